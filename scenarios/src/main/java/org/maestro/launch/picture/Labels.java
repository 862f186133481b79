package org.maestro.launch.picture;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.font.TextLayout;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;

/**
 * Names beside their symbols, each on the first side that is free; those asked for first choose
 * first.
 */
final class Labels {
  private static final double GAP = 24;
  private static final double SYMBOL = 18;

  private record Label(String text, Point2D at, Font font) {}

  private final Rectangle2D bounds;
  private final List<Label> labels = new ArrayList<>();
  private final List<Rectangle2D> taken = new ArrayList<>();

  /**
   * @param bounds that no label leaves
   */
  Labels(Rectangle2D bounds) {
    this.bounds = bounds;
  }

  /** A label for the symbol there. */
  void add(String text, Point2D symbol, Font font) {
    labels.add(new Label(text, symbol, font));
    keepFree(symbol);
  }

  /** No label is to cover the symbol there. */
  void keepFree(Point2D symbol) {
    taken.add(
        new Rectangle2D.Double(
            symbol.getX() - SYMBOL, symbol.getY() - SYMBOL, 2 * SYMBOL, 2 * SYMBOL));
  }

  void draw(Graphics2D canvas) {
    for (Label label : labels) {
      Rectangle2D box = place(canvas, label);
      taken.add(box);
      Texts.draw(canvas, label.text(), box.getX(), box.getMaxY() - 6, label.font(), Palette.INK);
    }
  }

  private Rectangle2D place(Graphics2D canvas, Label label) {
    TextLayout layout = new TextLayout(label.text(), label.font(), canvas.getFontRenderContext());
    double width = layout.getAdvance();
    double height = label.font().getSize() + 4.0;
    double x = label.at().getX();
    double y = label.at().getY();
    List<Point2D> corners =
        List.of(
            new Point2D.Double(x + GAP, y - height / 2),
            new Point2D.Double(x - GAP - width, y - height / 2),
            new Point2D.Double(x - width / 2, y - GAP - height),
            new Point2D.Double(x - width / 2, y + GAP - 4),
            new Point2D.Double(x + GAP / 2, y - GAP - height),
            new Point2D.Double(x + GAP / 2, y + GAP - 4),
            new Point2D.Double(x - GAP / 2 - width, y - GAP - height),
            new Point2D.Double(x - GAP / 2 - width, y + GAP - 4));
    for (Point2D corner : corners) {
      Rectangle2D box = new Rectangle2D.Double(corner.getX(), corner.getY(), width, height);
      if (bounds.contains(box) && taken.stream().noneMatch(box::intersects)) {
        return box;
      }
    }
    Point2D first = corners.get(0);
    return new Rectangle2D.Double(first.getX(), first.getY(), width, height);
  }
}
