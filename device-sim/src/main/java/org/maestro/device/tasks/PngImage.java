package org.maestro.device.tasks;

import static java.nio.charset.StandardCharsets.US_ASCII;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.util.zip.CRC32;
import java.util.zip.Deflater;
import org.maestro.hal.Photo;

/**
 * Pictures as PNG (ISO/IEC 15948), of 8 bits a colour and without loss. Devices need no graphics
 * system for it.
 */
final class PngImage {
  static final String MEDIA_TYPE = "image/png";

  private static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  private static final int CHANNELS = 3;

  private PngImage() {}

  static byte[] of(Photo photo) {
    ByteArrayOutputStream png = new ByteArrayOutputStream();
    png.writeBytes(SIGNATURE);
    byte[] header =
        ByteBuffer.allocate(13)
            .putInt(photo.width())
            .putInt(photo.height())
            .put(new byte[] {8, 2, 0, 0, 0})
            .array();
    add(png, "IHDR", header);
    add(png, "IDAT", deflated(rows(photo)));
    add(png, "IEND", new byte[0]);
    return png.toByteArray();
  }

  /** Each after a byte that says that it is not filtered: the pictures' noise leaves no gain. */
  private static byte[] rows(Photo photo) {
    ByteBuffer rows = ByteBuffer.allocate(photo.height() * (1 + CHANNELS * photo.width()));
    for (int row = 0; row < photo.height(); row++) {
      rows.put((byte) 0);
      for (int column = 0; column < photo.width(); column++) {
        int rgb = photo.at(column, row);
        rows.put((byte) (rgb >> 16)).put((byte) (rgb >> 8)).put((byte) rgb);
      }
    }
    return rows.array();
  }

  private static byte[] deflated(byte[] plain) {
    Deflater deflater = new Deflater();
    try {
      deflater.setInput(plain);
      deflater.finish();
      ByteArrayOutputStream all = new ByteArrayOutputStream();
      byte[] part = new byte[8192];
      while (!deflater.finished()) {
        all.write(part, 0, deflater.deflate(part));
      }
      return all.toByteArray();
    } finally {
      deflater.end();
    }
  }

  private static void add(ByteArrayOutputStream png, String kind, byte[] content) {
    byte[] chunk =
        ByteBuffer.allocate(4 + content.length).put(kind.getBytes(US_ASCII)).put(content).array();
    CRC32 sum = new CRC32();
    sum.update(chunk);
    png.writeBytes(ByteBuffer.allocate(4).putInt(content.length).array());
    png.writeBytes(chunk);
    png.writeBytes(ByteBuffer.allocate(4).putInt((int) sum.getValue()).array());
  }
}
