package org.maestro.experiment.drawing;

import java.awt.geom.Ellipse2D;
import java.awt.image.BufferedImage;
import java.util.List;
import org.jfree.chart.LegendItemCollection;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.NumberTickUnit;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYErrorRenderer;
import org.jfree.data.xy.XYIntervalSeries;
import org.jfree.data.xy.XYIntervalSeriesCollection;

/** Values with the interval in which each truly lies, over a number that was varied. */
public final class Whiskers {
  private static final double ROOM = 0.06;

  /**
   * A value with its interval.
   *
   * @param at the number that was varied
   */
  public record Point(double at, double value, double least, double greatest) {}

  /** Points of one ink. */
  public record Series(String label, Ink ink, List<Point> points) {}

  private Whiskers() {}

  /**
   * @param tick between two numbers on the axis across
   * @param greatest what the axis up shows
   */
  public static BufferedImage draw(
      String title, String across, double tick, String up, double greatest, List<Series> all) {
    NumberAxis varied = Style.axis(across);
    double most =
        all.stream()
            .flatMap(series -> series.points().stream())
            .mapToDouble(Point::at)
            .max()
            .orElse(1);
    varied.setRange(-ROOM, most + ROOM);
    varied.setTickUnit(new NumberTickUnit(tick));
    NumberAxis values = Style.axis(up);
    values.setRange(0, greatest);
    XYPlot plot = Style.plot(varied, values);
    XYIntervalSeriesCollection data = new XYIntervalSeriesCollection();
    XYErrorRenderer renderer = new XYErrorRenderer();
    renderer.setDrawXError(false);
    renderer.setErrorStroke(Ink.solid(4));
    renderer.setCapLength(14);
    LegendItemCollection legend = new LegendItemCollection();
    for (Series series : all) {
      int number = data.getSeriesCount();
      data.addSeries(points(series));
      renderer.setSeriesPaint(number, series.ink().color());
      renderer.setSeriesShape(number, new Ellipse2D.Double(-9, -9, 18, 18));
      legend.add(Style.dot(series.label(), series.ink()));
    }
    plot.setDataset(0, data);
    plot.setRenderer(0, renderer);
    plot.setFixedLegendItems(legend);
    return Style.image(Style.chart(title, plot));
  }

  private static XYIntervalSeries points(Series series) {
    XYIntervalSeries points = new XYIntervalSeries(series.label());
    for (Point point : series.points()) {
      points.add(
          point.at(), point.at(), point.at(), point.value(), point.least(), point.greatest());
    }
    return points;
  }
}
