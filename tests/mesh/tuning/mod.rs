//! Laws of fine-tuned subdivision surfaces.

mod shapes;
mod oracle;
mod hostile;
mod laws;
mod news;
