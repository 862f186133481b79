package org.maestro.picture;

import java.awt.BasicStroke;
import java.awt.Color;
import org.maestro.hal.sight.Paint;

/**
 * Colours that colour-blind people can tell apart (Okabe and Ito); every meaning has a shape of its
 * own too. Things have their own colours, and their names beside them.
 */
final class Palette {
  static final Color INK = new Color(0x22, 0x22, 0x22);
  static final Color ZONE = new Color(0x88, 0x88, 0x88);
  static final Color CAMERA = new Color(0x00, 0x72, 0xB2);
  static final Color LAMP = new Color(0xF0, 0xE4, 0x42);
  static final Color ROBOT = new Color(0xD5, 0x5E, 0x00);
  static final Color PERSON = new Color(0x00, 0x9E, 0x73);
  static final Color GLASS = new Color(0x56, 0xB4, 0xE9);
  static final Color DOOR = new Color(0x8A, 0x5A, 0x2B);
  private static final int DARK = 0xB4;

  private Palette() {}

  /** A thing's own colour in bright light, as a screen shows it (sRGB, IEC 61966-2-1). */
  static Color screen(Paint paint) {
    return new Color(
        (float) gamma(paint.red()), (float) gamma(paint.green()), (float) gamma(paint.blue()));
  }

  private static double gamma(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * Math.pow(linear, 1 / 2.4) - 0.055;
  }

  /**
   * @param light 0 for dark, 1 for bright
   */
  static Color floor(double light) {
    int grey = (int) Math.round(DARK + light * (0xFD - DARK));
    return new Color(grey, grey, Math.min(255, grey + 1));
  }

  static BasicStroke dashed(float width) {
    return new BasicStroke(
        width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER, 10, new float[] {10, 8}, 0);
  }
}
