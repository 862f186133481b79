package org.maestro.ontology.validation;

import java.util.Comparator;
import java.util.Optional;
import org.apache.jena.graph.Graph;
import org.apache.jena.graph.Node;
import org.apache.jena.riot.Lang;
import org.apache.jena.riot.RDFParser;
import org.apache.jena.shacl.ShaclValidator;
import org.apache.jena.shacl.Shapes;
import org.apache.jena.shacl.validation.ReportEntry;
import org.apache.jena.sparql.graph.GraphFactory;
import org.apache.jena.sparql.path.P_Link;
import org.apache.jena.sparql.path.Path;

/**
 * Holds a graph against SHACL shapes whose messages are a problem and, after a semicolon, its cure.
 */
public final class ShapeCheck {

  private final Shapes shapes;

  /**
   * @param turtle the shapes
   */
  public ShapeCheck(String turtle) {
    Graph graph = GraphFactory.createDefaultGraph();
    RDFParser.fromString(turtle, Lang.TURTLE).parse(graph);
    this.shapes = Shapes.parse(graph);
  }

  /** Every violation becomes a fault of the graph. */
  public void check(SourceGraph graph) {
    ShaclValidator.get().validate(shapes, graph.toGraph()).getEntries().stream()
        .sorted(
            Comparator.comparing((ReportEntry entry) -> entry.message())
                .thenComparing(entry -> String.valueOf(entry.value())))
        .forEach(entry -> note(graph, entry));
  }

  private static void note(SourceGraph graph, ReportEntry entry) {
    String[] parts = entry.message().split("; ", 2);
    String cure = parts.length > 1 ? parts[1] : "correct it";
    Optional<Node> property = property(entry.resultPath());
    if (property.isPresent()) {
      graph.fault(
          entry.focusNode(), property.get(), Optional.ofNullable(entry.value()), parts[0], cure);
    } else {
      graph.fault(entry.focusNode(), parts[0], cure);
    }
  }

  private static Optional<Node> property(Path path) {
    return path instanceof P_Link link ? Optional.of(link.getNode()) : Optional.empty();
  }
}
