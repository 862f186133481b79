package org.maestro.ontology.home;

import java.util.Comparator;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.apache.jena.graph.Node;
import org.apache.jena.vocabulary.RDFS;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.sl.Point;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlSyntaxException;
import org.maestro.sl.Term;

/**
 * Finds the points that a home's file names by their coordinates, in goals, rules and scripts: they
 * are things of that home.
 */
final class PointReader {
  private static final String NUMBER = "\\s+[-+]?[\\d.]+(?:[eE][-+]?\\d+)?";
  private static final Pattern POINT = Pattern.compile("\\(\\s*at(?:" + NUMBER + "){2,3}\\s*\\)");

  /** What people read is no MAESTRO-SL. */
  private static final Set<Node> FOR_PEOPLE = Set.of(RDFS.label.asNode(), RDFS.comment.asNode());

  private final SourceGraph graph;
  private final String source;

  PointReader(SourceGraph graph, String source) {
    this.graph = graph;
    this.source = source;
  }

  /** The points, and what names each. */
  Map<Point, Node> read() {
    Map<Point, Node> points = new TreeMap<>(Comparator.comparing(Point::name));
    for (Node subject : graph.subjectsOf(source)) {
      for (Node property : graph.predicates(subject)) {
        if (!FOR_PEOPLE.contains(property)) {
          graph.objects(subject, property).forEach(value -> read(subject, value, points));
        }
      }
    }
    return points;
  }

  private static void read(Node subject, Node value, Map<Point, Node> points) {
    if (!value.isLiteral()) {
      return;
    }
    Matcher found = POINT.matcher(value.getLiteralLexicalForm());
    while (found.find()) {
      point(found.group()).ifPresent(point -> points.putIfAbsent(point, subject));
    }
  }

  /** What cannot be read is told by who reads the whole. */
  private static Optional<Point> point(String text) {
    try {
      return SlParser.term(text) instanceof Term.Name name
          ? Point.named(name.text())
          : Optional.empty();
    } catch (SlSyntaxException e) {
      return Optional.empty();
    }
  }
}
