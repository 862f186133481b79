package org.maestro.experiment.drawing;

import java.awt.BasicStroke;
import java.awt.Color;

/** Colours of Okabe and Ito, which colour-blind people can tell apart, and strokes. */
public enum Ink {
  BLACK(0x222222),
  GREY(0x8C8C8C),
  DARK_GREY(0x4D4D4D),
  GREEN(0x009E73),
  RED(0xD55E00),
  BLUE(0x0072B2),
  SKY(0x56B4E9),
  ORANGE(0xE69F00),
  PURPLE(0xCC79A7);

  private final Color color;

  Ink(int rgb) {
    this.color = new Color(rgb);
  }

  Color color() {
    return color;
  }

  static BasicStroke solid(double width) {
    return new BasicStroke((float) width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
  }

  static BasicStroke dashed(double width) {
    return new BasicStroke(
        (float) width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER, 10, new float[] {14, 9}, 0);
  }
}
