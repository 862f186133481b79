package org.maestro.experiment.drawing;

import java.awt.Color;
import java.awt.Paint;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jfree.chart.LegendItemCollection;
import org.jfree.chart.axis.AxisLocation;
import org.jfree.chart.axis.CategoryAxis;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.NumberTickUnit;
import org.jfree.chart.plot.CategoryPlot;
import org.jfree.chart.plot.PlotOrientation;
import org.jfree.chart.renderer.category.IntervalBarRenderer;
import org.jfree.chart.renderer.category.StandardBarPainter;
import org.jfree.data.category.DefaultIntervalCategoryDataset;

/** A Gantt chart of who did what when: a row for each deed, in the colour of who did it. */
public final class Timeline {
  private static final List<Ink> INKS =
      List.of(Ink.BLUE, Ink.ORANGE, Ink.GREEN, Ink.PURPLE, Ink.SKY, Ink.BLACK);
  private static final int ROW_HEIGHT = 64;
  private static final int FRAME_HEIGHT = 250;
  private static final float MOST_OF_A_ROW = 0.62f;

  /**
   * @param what a sentence that names who does it
   * @param begin seconds
   * @param end seconds
   * @param done whether it came to a good end
   */
  public record Deed(String who, String what, double begin, double end, boolean done) {}

  private Timeline() {}

  /**
   * @param deeds at least one, in the order of their rows
   */
  public static BufferedImage draw(String title, String axis, List<Deed> deeds) {
    Map<String, Ink> inks = new LinkedHashMap<>();
    List<Ink> inkOfRow = new ArrayList<>();
    for (Deed deed : deeds) {
      inkOfRow.add(inks.computeIfAbsent(deed.who(), who -> INKS.get(inks.size() % INKS.size())));
    }
    IntervalBarRenderer renderer =
        new IntervalBarRenderer() {
          private static final long serialVersionUID = 1L;

          @Override
          public Paint getItemPaint(int row, int column) {
            Deed deed = deeds.get(column);
            return deed.done() ? inkOfRow.get(column).color() : Ink.GREY.color();
          }
        };
    renderer.setBarPainter(new StandardBarPainter());
    renderer.setShadowVisible(false);
    LegendItemCollection legend = new LegendItemCollection();
    inks.forEach((who, ink) -> legend.add(Style.patch(who, ink.color())));
    if (!deeds.stream().allMatch(Deed::done)) {
      legend.add(Style.patch("came to no good end", Ink.GREY.color()));
    }
    CategoryAxis rows = new CategoryAxis();
    Style.ink(rows);
    rows.setMaximumCategoryLabelWidthRatio(MOST_OF_A_ROW);
    NumberAxis time = Style.axis(axis);
    double last = Math.max(1, deeds.stream().mapToDouble(Deed::end).max().orElse(0));
    time.setRange(0, Math.ceil(last));
    time.setTickUnit(new NumberTickUnit(TimeChart.tick(last)));
    CategoryPlot plot = new CategoryPlot(data(deeds), rows, time, renderer);
    plot.setOrientation(PlotOrientation.HORIZONTAL);
    plot.setRangeAxisLocation(AxisLocation.BOTTOM_OR_LEFT);
    plot.setBackgroundPaint(Color.WHITE);
    plot.setRangeGridlinePaint(new Color(0xDD, 0xDD, 0xDD));
    plot.setOutlinePaint(Ink.BLACK.color());
    plot.setFixedLegendItems(legend);
    return Style.image(
        Style.chart(title, plot), Style.WIDTH, FRAME_HEIGHT + ROW_HEIGHT * deeds.size());
  }

  /** Rows are told apart by their number, since the same may be done twice. */
  private static DefaultIntervalCategoryDataset data(List<Deed> deeds) {
    Double[][] begins = new Double[1][deeds.size()];
    Double[][] ends = new Double[1][deeds.size()];
    String[] rows = new String[deeds.size()];
    for (int i = 0; i < deeds.size(); i++) {
      begins[0][i] = deeds.get(i).begin();
      ends[0][i] = deeds.get(i).end();
      rows[i] = "%d. %s".formatted(i + 1, deeds.get(i).what());
    }
    return new DefaultIntervalCategoryDataset(new String[] {"deeds"}, rows, begins, ends);
  }
}
