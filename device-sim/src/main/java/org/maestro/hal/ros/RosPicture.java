package org.maestro.hal.ros;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.Base64;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.maestro.hal.Photo;

/** The reading of sensor_msgs/CompressedImage, whose bytes rosbridge writes in base64. */
final class RosPicture {
  private static final int WITHOUT_ALPHA = 0xFFFFFF;

  private RosPicture() {}

  /**
   * @throws RosMessageException when they are not written so
   */
  static byte[] bytes(RosFields message) {
    try {
      return Base64.getDecoder().decode(message.text("data"));
    } catch (IllegalArgumentException e) {
      throw new RosMessageException("data is no base64");
    }
  }

  /** Empty when the bytes are no PNG or JPEG. */
  static Optional<Photo> photo(byte[] bytes) {
    try {
      return Optional.ofNullable(ImageIO.read(new ByteArrayInputStream(bytes)))
          .map(RosPicture::photo);
    } catch (IOException | IllegalArgumentException | IndexOutOfBoundsException e) {
      return Optional.empty();
    }
  }

  private static Photo photo(BufferedImage image) {
    int width = image.getWidth();
    int height = image.getHeight();
    int[] pixels = image.getRGB(0, 0, width, height, null, 0, width);
    return new Photo(width, height, Arrays.stream(pixels).map(p -> p & WITHOUT_ALPHA).toArray());
  }
}
