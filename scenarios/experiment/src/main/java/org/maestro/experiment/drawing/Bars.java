package org.maestro.experiment.drawing;

import java.awt.Color;
import java.awt.Paint;
import java.awt.TexturePaint;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.jfree.chart.LegendItem;
import org.jfree.chart.LegendItemCollection;
import org.jfree.chart.annotations.XYTextAnnotation;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.StandardXYBarPainter;
import org.jfree.chart.renderer.xy.XYBarRenderer;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.chart.ui.Layer;
import org.jfree.chart.ui.TextAnchor;
import org.jfree.data.xy.DefaultXYDataset;
import org.jfree.data.xy.XYBarDataset;

/** A bar for each run, failed ones marked, with lines and a dot for what each is compared with. */
public final class Bars {
  private static final double BAR_WIDTH = 0.72;
  private static final int HATCH = 14;

  /**
   * @param group the legend's word for bars of this ink
   * @param compared drawn as a dash over the bar
   */
  public record Bar(double value, String group, Ink ink, boolean failed, OptionalDouble compared) {}

  /** A level that is drawn across all bars; the legend tells what it is. */
  public record Level(double value, String label, Ink ink) {}

  private Bars() {}

  /**
   * @param comparedWith the legend's word for what bars are compared with; unused when nothing is
   */
  public static BufferedImage draw(
      String title,
      String across,
      String up,
      List<Bar> bars,
      List<Level> levels,
      String comparedWith) {
    NumberAxis runs = Style.axis(across);
    runs.setRange(0.3, bars.size() + 0.7);
    runs.setStandardTickUnits(NumberAxis.createIntegerTickUnits());
    NumberAxis values = Style.axis(up);
    double greatest =
        bars.stream()
            .mapToDouble(bar -> Math.max(bar.value(), bar.compared().orElse(0)))
            .max()
            .orElse(1);
    for (Level level : levels) {
      greatest = Math.max(greatest, level.value());
    }
    values.setRange(0, greatest <= 0 ? 1 : greatest * 1.22);
    XYPlot plot = Style.plot(runs, values);
    plot.setDomainGridlinesVisible(false);
    drawDashes(plot, bars);
    drawBars(plot, bars);
    for (Level level : levels) {
      plot.addRangeMarker(Style.line(level.value(), level.ink()), Layer.FOREGROUND);
    }
    plot.setFixedLegendItems(legend(bars, levels, comparedWith));
    return Style.image(Style.chart(title, plot));
  }

  private static void drawBars(XYPlot plot, List<Bar> bars) {
    DefaultXYDataset data = new DefaultXYDataset();
    double[][] points = new double[2][bars.size()];
    for (int i = 0; i < bars.size(); i++) {
      points[0][i] = i + 1;
      points[1][i] = bars.get(i).value();
    }
    data.addSeries("bars", points);
    XYBarRenderer renderer =
        new XYBarRenderer() {
          private static final long serialVersionUID = 1L;

          @Override
          public Paint getItemPaint(int series, int item) {
            return paint(bars.get(item));
          }

          @Override
          public Paint getItemOutlinePaint(int series, int item) {
            return bars.get(item).failed() ? Ink.BLACK.color() : bars.get(item).ink().color();
          }
        };
    renderer.setBarPainter(new StandardXYBarPainter());
    renderer.setShadowVisible(false);
    renderer.setDrawBarOutline(true);
    plot.setDataset(1, new XYBarDataset(data, BAR_WIDTH));
    plot.setRenderer(1, renderer);
    for (int i = 0; i < bars.size(); i++) {
      if (bars.get(i).failed()) {
        XYTextAnnotation cross = new XYTextAnnotation("✗", i + 1, bars.get(i).value());
        cross.setFont(Style.TITLE);
        cross.setPaint(Ink.BLACK.color());
        cross.setTextAnchor(TextAnchor.BOTTOM_CENTER);
        plot.addAnnotation(cross);
      }
    }
  }

  private static void drawDashes(XYPlot plot, List<Bar> bars) {
    DefaultXYDataset data = new DefaultXYDataset();
    double[][] points = new double[2][bars.size()];
    for (int i = 0; i < bars.size(); i++) {
      points[0][i] = i + 1;
      points[1][i] = bars.get(i).compared().orElse(Double.NaN);
    }
    data.addSeries("compared", points);
    XYLineAndShapeRenderer renderer = new XYLineAndShapeRenderer(false, true);
    renderer.setSeriesShape(0, new Rectangle2D.Double(-16, -3, 32, 6));
    renderer.setSeriesPaint(0, Ink.BLACK.color());
    plot.setDataset(0, data);
    plot.setRenderer(0, renderer);
  }

  private static Paint paint(Bar bar) {
    return bar.failed() ? hatched(bar.ink()) : bar.ink().color();
  }

  /** Dark grey with stripes of its own colour. */
  private static Paint hatched(Ink ink) {
    BufferedImage tile = new BufferedImage(HATCH, HATCH, BufferedImage.TYPE_INT_RGB);
    for (int x = 0; x < HATCH; x++) {
      for (int y = 0; y < HATCH; y++) {
        Color color = (x + y) % HATCH < 4 ? ink.color() : Ink.DARK_GREY.color();
        tile.setRGB(x, y, color.getRGB());
      }
    }
    return new TexturePaint(tile, new Rectangle2D.Double(0, 0, HATCH, HATCH));
  }

  private static LegendItemCollection legend(
      List<Bar> bars, List<Level> levels, String comparedWith) {
    Map<String, LegendItem> items = new LinkedHashMap<>();
    for (Bar bar : bars) {
      items.computeIfAbsent(
          bar.failed() ? bar.group() + ", failed (✗)" : bar.group(),
          label -> Style.patch(label, paint(bar)));
    }
    LegendItemCollection legend = new LegendItemCollection();
    items.values().forEach(legend::add);
    if (bars.stream().anyMatch(bar -> bar.compared().isPresent())) {
      LegendItem dash = Style.patch(comparedWith, Ink.BLACK.color());
      dash.setShape(new Rectangle2D.Double(-15, -3, 30, 6));
      legend.add(dash);
    }
    levels.forEach(level -> legend.add(Style.dash(level.label(), level.ink())));
    return legend;
  }
}
