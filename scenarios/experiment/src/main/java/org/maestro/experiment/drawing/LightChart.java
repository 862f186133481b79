package org.maestro.experiment.drawing;

import java.awt.geom.Ellipse2D;
import java.awt.image.BufferedImage;
import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.util.List;
import java.util.Locale;
import org.jfree.chart.LegendItemCollection;
import org.jfree.chart.axis.LogAxis;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.NumberTickUnit;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;

/** A share over the light, which stands on an axis of equal ratios. */
public final class LightChart {
  private static final int DECADE = 10;

  private LightChart() {}

  /**
   * @param share label of the axis; points are lux and percent
   * @param dots what was seen
   * @param line what is reckoned with
   * @param threshold a labelled light
   */
  public static BufferedImage draw(
      String title,
      String share,
      TimeChart.Series dots,
      TimeChart.Series line,
      TimeChart.Event threshold) {
    LogAxis light = new LogAxis("light upon the object (lux)");
    light.setBase(DECADE);
    light.setNumberFormatOverride(
        new DecimalFormat("0.#", DecimalFormatSymbols.getInstance(Locale.ROOT)));
    Style.ink(light);
    NumberAxis up = Style.axis(share);
    up.setRange(-3, 109);
    up.setTickUnit(new NumberTickUnit(20));
    XYPlot plot = Style.plot(light, up);
    plot.setDataset(0, TimeChart.data(List.of(line)));
    XYLineAndShapeRenderer stroke = new XYLineAndShapeRenderer(true, false);
    stroke.setSeriesPaint(0, line.ink().color());
    stroke.setSeriesStroke(0, Ink.solid(5));
    plot.setRenderer(0, stroke);
    plot.setDataset(1, TimeChart.data(List.of(dots)));
    XYLineAndShapeRenderer scatter = new XYLineAndShapeRenderer(false, true);
    scatter.setSeriesShape(0, new Ellipse2D.Double(-6, -6, 12, 12));
    scatter.setSeriesPaint(0, dots.ink().color());
    plot.setRenderer(1, scatter);
    plot.addDomainMarker(TimeChart.marker(threshold));
    LegendItemCollection legend = new LegendItemCollection();
    legend.add(Style.dot(dots.label(), dots.ink()));
    legend.add(Style.stroke(line.label(), line.ink()));
    plot.setFixedLegendItems(legend);
    return Style.image(Style.chart(title, plot));
  }
}
