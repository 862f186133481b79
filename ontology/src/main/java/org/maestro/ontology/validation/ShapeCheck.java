package org.maestro.ontology.validation;

import java.util.Comparator;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.apache.jena.graph.Graph;
import org.apache.jena.graph.Node;
import org.apache.jena.graph.NodeFactory;
import org.apache.jena.riot.Lang;
import org.apache.jena.riot.RDFParser;
import org.apache.jena.shacl.ShaclValidator;
import org.apache.jena.shacl.Shapes;
import org.apache.jena.shacl.validation.ReportEntry;
import org.apache.jena.shacl.validation.Severity;
import org.apache.jena.shared.PrefixMapping;
import org.apache.jena.sparql.graph.GraphFactory;
import org.apache.jena.sparql.path.P_Link;
import org.apache.jena.sparql.path.Path;

/**
 * Holds a graph against SHACL shapes whose messages are a problem and, after a semicolon, its cure.
 */
public final class ShapeCheck {

  private static final Pattern WORD = Pattern.compile("(?<![\\w\"])\\w*:[A-Za-z]\\w*");

  private final Shapes shapes;
  private final PrefixMapping prefixes;

  /**
   * @param turtle the shapes
   */
  public ShapeCheck(String turtle) {
    Graph graph = GraphFactory.createDefaultGraph();
    RDFParser.fromString(turtle, Lang.TURTLE).parse(graph);
    this.shapes = Shapes.parse(graph);
    this.prefixes = graph.getPrefixMapping();
  }

  /** Every violation becomes a fault of the graph. */
  public void check(SourceGraph graph) {
    check(graph, graph::fault);
  }

  /**
   * Every violation becomes a fault of the graph.
   *
   * @param warnings takes what the shapes call a warning
   */
  public void check(SourceGraph graph, Consumer<Fault> warnings) {
    ShaclValidator.get().validate(shapes, graph.toGraph()).getEntries().stream()
        .sorted(
            Comparator.comparing((ReportEntry entry) -> entry.message())
                .thenComparing(entry -> String.valueOf(entry.value())))
        .forEach(
            entry -> {
              if (Severity.Warning.equals(entry.severity())) {
                warnings.accept(told(graph, entry));
              } else {
                graph.fault(told(graph, entry));
              }
            });
  }

  private Fault told(SourceGraph graph, ReportEntry entry) {
    String[] parts = written(entry.message(), graph).split("; ", 2);
    String cure = parts.length > 1 ? parts[1] : "correct it";
    return property(entry.resultPath())
        .map(
            property ->
                graph.told(
                    entry.focusNode(),
                    property,
                    Optional.ofNullable(entry.value()),
                    parts[0],
                    cure))
        .orElseGet(() -> graph.told(entry.focusNode(), parts[0], cure));
  }

  /** A message with its words as the text that is checked would write them. */
  private String written(String message, SourceGraph graph) {
    return WORD.matcher(message)
        .replaceAll(
            word -> {
              String iri = prefixes.expandPrefix(word.group());
              return Matcher.quoteReplacement(
                  iri.equals(word.group()) ? iri : graph.written(NodeFactory.createURI(iri)));
            });
  }

  private static Optional<Node> property(Path path) {
    return path instanceof P_Link link ? Optional.of(link.getNode()) : Optional.empty();
  }
}
