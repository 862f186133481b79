package org.maestro.experiment.drawing;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;

/**
 * A figure with what a reader needs to know of it.
 *
 * @param name of its file, without ending
 * @param caption a sentence or two
 * @param png the image
 */
public record Figure(String name, String caption, byte[] png) {

  public static Figure of(String name, String caption, BufferedImage image) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try {
      ImageIO.write(image, "png", bytes);
    } catch (IOException e) {
      throw new UncheckedIOException("The figure " + name + " cannot be drawn.", e);
    }
    return new Figure(name, caption, bytes.toByteArray());
  }

  /** One that was drawn into a file. */
  public static Figure read(String name, String caption, Path file) {
    try {
      return new Figure(name, caption, Files.readAllBytes(file));
    } catch (IOException e) {
      throw new UncheckedIOException("The figure " + file + " cannot be read.", e);
    }
  }

  /** Writes it into the directory. */
  public void write(Path directory) {
    Path file = directory.resolve(name + ".png");
    try {
      Files.write(file, png);
    } catch (IOException e) {
      throw new UncheckedIOException("The figure " + file + " cannot be written.", e);
    }
  }
}
