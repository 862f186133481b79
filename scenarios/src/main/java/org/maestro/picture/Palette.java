package org.maestro.picture;

import java.awt.BasicStroke;
import java.awt.Color;

/**
 * Colours that colour-blind people can tell apart (Okabe and Ito); every meaning has a shape of its
 * own too.
 */
final class Palette {
  static final Color INK = new Color(0x22, 0x22, 0x22);
  static final Color ZONE = new Color(0x88, 0x88, 0x88);
  static final Color CAMERA = new Color(0x00, 0x72, 0xB2);
  static final Color LAMP = new Color(0xF0, 0xE4, 0x42);
  static final Color ROBOT = new Color(0xD5, 0x5E, 0x00);
  static final Color PERSON = new Color(0x00, 0x9E, 0x73);
  static final Color THING = new Color(0xCC, 0x79, 0xA7);
  static final Color DOOR = new Color(0x8A, 0x5A, 0x2B);
  private static final int DARK = 0xB4;

  private Palette() {}

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
