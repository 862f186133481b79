package org.maestro.experiment.drawing;

import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import org.maestro.hal.Photo;

/**
 * A figure with what a reader needs to know of it.
 *
 * @param name of its file, without ending
 * @param caption a sentence or two
 * @param png the image
 */
public record Figure(String name, String caption, byte[] png) {
  private static final int PHOTO_WIDTH = 960;

  public static Figure of(String name, String caption, BufferedImage image) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    // A cache in a file, as it is usual, cannot be made any more while the process is being ended.
    try (ImageOutputStream stream = new MemoryCacheImageOutputStream(bytes)) {
      ImageIO.write(image, "png", stream);
    } catch (IOException e) {
      throw new UncheckedIOException("The figure " + name + " cannot be drawn.", e);
    }
    return new Figure(name, caption, bytes.toByteArray());
  }

  /** What a camera shows, as large as fits a page. */
  public static Figure of(String name, String caption, Photo photo) {
    BufferedImage image =
        new BufferedImage(photo.width(), photo.height(), BufferedImage.TYPE_INT_RGB);
    image.setRGB(0, 0, photo.width(), photo.height(), photo.rgb(), 0, photo.width());
    int height = (int) Math.round((double) PHOTO_WIDTH * photo.height() / photo.width());
    BufferedImage smaller = new BufferedImage(PHOTO_WIDTH, height, BufferedImage.TYPE_INT_RGB);
    Graphics2D canvas = smaller.createGraphics();
    canvas.setRenderingHint(
        RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
    canvas.drawImage(image, 0, 0, PHOTO_WIDTH, height, null);
    canvas.dispose();
    return of(name, caption, smaller);
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
