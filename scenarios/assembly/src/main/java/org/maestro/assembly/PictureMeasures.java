package org.maestro.assembly;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Map;
import javax.imageio.ImageIO;
import org.maestro.rats.protocol.StreamFrame;

/** How bright pictures are in the mean, and which share of each is otherwise than before. */
final class PictureMeasures implements FrameMeasures {
  private static final double END = 255;
  private static final int MOST_PIXELS = 4_000_000;

  /** Of 255; the noise of our cameras' pictures has a standard deviation of less than 9. */
  private static final int OTHERWISE = 40;

  private int[] before = {};

  @Override
  public Map<String, Double> of(StreamFrame frame) {
    int[] now = luminances(picture(frame));
    double sum = 0;
    int changed = 0;
    for (int i = 0; i < now.length; i++) {
      sum += now[i];
      changed += before.length == now.length && Math.abs(now[i] - before[i]) > OTHERWISE ? 1 : 0;
    }
    before = now;
    return Map.of("brightness", sum / now.length / END, "motion", (double) changed / now.length);
  }

  private static BufferedImage picture(StreamFrame frame) {
    try {
      BufferedImage picture = ImageIO.read(new ByteArrayInputStream(frame.data()));
      if (picture != null && (long) picture.getWidth() * picture.getHeight() <= MOST_PIXELS) {
        return picture;
      }
      throw new IllegalArgumentException("it is no picture that is known here");
    } catch (IOException broken) {
      throw new IllegalArgumentException("the picture is broken", broken);
    }
  }

  /** As ITU-R BT.601 weighs the colours. */
  private static int[] luminances(BufferedImage picture) {
    int[] pixels =
        picture.getRGB(0, 0, picture.getWidth(), picture.getHeight(), null, 0, picture.getWidth());
    for (int i = 0; i < pixels.length; i++) {
      int rgb = pixels[i];
      pixels[i] = (299 * (rgb >> 16 & 0xff) + 587 * (rgb >> 8 & 0xff) + 114 * (rgb & 0xff)) / 1000;
    }
    return pixels;
  }
}
