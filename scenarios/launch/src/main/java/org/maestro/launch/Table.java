package org.maestro.launch;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import org.maestro.text.VisibleText;

/** Rows under column names, for people or as JSON. */
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

  /** One document: an object with the rows under the given name. */
  String json(String name) {
    ObjectNode document = new ObjectMapper().createObjectNode();
    ArrayNode array = document.putArray(name);
    for (List<String> row : rows) {
      ObjectNode node = array.addObject();
      for (int column = 0; column < columns.size(); column++) {
        node.put(columns.get(column), row.get(column));
      }
    }
    return document.toString();
  }
}
