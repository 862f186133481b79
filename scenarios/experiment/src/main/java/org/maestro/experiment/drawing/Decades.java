package org.maestro.experiment.drawing;

import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import org.jfree.chart.axis.AxisState;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.NumberTick;
import org.jfree.chart.axis.ValueTick;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.chart.ui.TextAnchor;

/** An axis of decimal logarithms whose ticks are at 1, 2 and 5 of each decade. */
final class Decades extends NumberAxis {
  private static final long serialVersionUID = 1L;
  private static final int[] MANTISSAS = {1, 2, 5};
  private static final double NEAR = 1e-9;

  Decades(String label) {
    super(label);
  }

  @Override
  public List<ValueTick> refreshTicks(
      Graphics2D graphics, AxisState state, Rectangle2D area, RectangleEdge edge) {
    List<ValueTick> ticks = new ArrayList<>();
    for (int exponent = (int) Math.floor(getLowerBound());
        exponent <= getUpperBound();
        exponent++) {
      for (int mantissa : MANTISSAS) {
        double place = exponent + Math.log10(mantissa);
        if (place >= getLowerBound() - NEAR && place <= getUpperBound() + NEAR) {
          String label = BigDecimal.valueOf(mantissa).scaleByPowerOfTen(exponent).toPlainString();
          TextAnchor anchor =
              edge.equals(RectangleEdge.LEFT) ? TextAnchor.CENTER_RIGHT : TextAnchor.CENTER_LEFT;
          ticks.add(new NumberTick(place, label, anchor, TextAnchor.CENTER, 0));
        }
      }
    }
    return ticks;
  }
}
