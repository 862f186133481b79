package org.maestro.launch;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import org.maestro.text.VisibleText;

/** Rows under column names, for people. */
record Table(List<String> columns, List<List<String>> rows) {

  void print(PrintWriter out) {
    new Table(
            columns,
            rows.stream().map(row -> row.stream().map(VisibleText::line).toList()).toList())
        .printVisible(out);
  }

  private void printVisible(PrintWriter out) {
    List<Integer> widths = new ArrayList<>();
    for (int column = 0; column < columns.size(); column++) {
      int width = columns.get(column).length();
      for (List<String> row : rows) {
        width = Math.max(width, row.get(column).length());
      }
      widths.add(width);
    }
    out.println(line(columns, widths));
    rows.forEach(row -> out.println(line(row, widths)));
  }

  private static String line(List<String> cells, List<Integer> widths) {
    StringBuilder line = new StringBuilder();
    for (int column = 0; column < cells.size(); column++) {
      line.append(cells.get(column));
      line.append(" ".repeat(widths.get(column) - cells.get(column).length() + 2));
    }
    return line.toString().stripTrailing();
  }
}
