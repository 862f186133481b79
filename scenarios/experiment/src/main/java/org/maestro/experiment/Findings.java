package org.maestro.experiment;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.maestro.experiment.drawing.Figure;
import org.maestro.experiment.measuring.Table;
import org.maestro.experiment.page.Page;

/**
 * The findings of an experiment: figures, raw data, drawings and a page.
 *
 * @param tables raw data, by file name without ending
 * @param results its main figures
 * @param summary what people are told in place of the results, where one table says more
 */
public record Findings(
    String experiment,
    List<Result> results,
    Map<String, Table> tables,
    List<Figure> figures,
    Page page,
    Optional<Summary> summary) {
  private static final String PAGE = "index.html";

  public Findings {
    results = List.copyOf(results);
    tables = Collections.unmodifiableMap(new LinkedHashMap<>(tables));
    figures = List.copyOf(figures);
  }

  /** Of which the results are all that is to be told. */
  Findings(
      String experiment,
      List<Result> results,
      Map<String, Table> tables,
      List<Figure> figures,
      Page page) {
    this(experiment, results, tables, figures, page, Optional.empty());
  }

  /** The same, summed up. */
  Findings summed(Summary told) {
    return new Findings(experiment, results, tables, figures, page, Optional.of(told));
  }

  /** One table, and what is said of it in sentences. */
  public record Summary(Table table, List<String> sentences) {
    public Summary {
      sentences = List.copyOf(sentences);
    }
  }

  /** A figure that was measured; NaN where there was nothing to measure. */
  public record Result(String name, double value, String unit) {

    /** For people. */
    public String line() {
      return Double.isNaN(value)
          ? "%-58s        -".formatted(name)
          : String.format(Locale.ROOT, "%-58s %9.2f %s", name, value, unit).stripTrailing();
    }
  }

  /**
   * Writes tables, figures and page into the directory, which is made if it is not there.
   *
   * @return the page's file
   */
  public Path write(Path directory) {
    try {
      Files.createDirectories(directory);
    } catch (IOException e) {
      throw new UncheckedIOException("The directory " + directory + " cannot be made.", e);
    }
    tables.forEach((name, table) -> table.write(directory.resolve(name + ".csv")));
    figures.forEach(figure -> figure.write(directory));
    Path file = directory.resolve(PAGE);
    page.write(file);
    return file;
  }

  /**
   * One document.
   *
   * @param course whose findings these are
   */
  public String json(Path directory, Course<?> course) {
    ObjectNode document = new ObjectMapper().createObjectNode();
    document.put("experiment", experiment);
    document.put("directory", directory.toString());
    document.put("page", directory.resolve(PAGE).toString());
    document.put("runs_done", course.done());
    document.put("runs_asked", course.runs());
    var array = document.putArray("results");
    for (Result result : results) {
      ObjectNode node = array.addObject();
      node.put("name", result.name());
      if (Double.isNaN(result.value())) {
        node.putNull("value");
      } else {
        node.put("value", result.value());
      }
      if (result.unit().isEmpty()) {
        node.putNull("unit");
      } else {
        node.put("unit", result.unit());
      }
    }
    ArrayNode sentences = document.putArray("sentences");
    summary.ifPresent(told -> told.sentences().forEach(sentences::add));
    return document.toString();
  }
}
