package org.maestro.picture;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.font.TextLayout;
import java.awt.geom.AffineTransform;
import org.maestro.text.VisibleText;

/** Labels with a white edge, so that they can be read on anything. */
final class Texts {
  static final Font TITLE = new Font(Font.SANS_SERIF, Font.BOLD, 36);
  static final Font NORMAL = new Font(Font.SANS_SERIF, Font.BOLD, 27);
  static final Font SMALL = new Font(Font.SANS_SERIF, Font.PLAIN, 23);

  private Texts() {}

  static void draw(Graphics2D canvas, String text, double x, double y, Font font, Color color) {
    Shape outline =
        new TextLayout(VisibleText.line(text), font, canvas.getFontRenderContext())
            .getOutline(AffineTransform.getTranslateInstance(x, y));
    canvas.setStroke(new BasicStroke(5, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    canvas.setColor(new Color(255, 255, 255, 220));
    canvas.draw(outline);
    canvas.setColor(color);
    canvas.fill(outline);
  }
}
