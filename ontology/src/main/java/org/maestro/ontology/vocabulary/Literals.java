package org.maestro.ontology.vocabulary;

import java.time.Duration;
import java.time.format.DateTimeParseException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;
import org.apache.jena.graph.Node;
import org.apache.jena.vocabulary.RDFS;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.sl.SlSyntaxException;
import org.maestro.sl.Term;

/** Reads values out of statements; what is not as expected becomes a fault of the graph. */
public final class Literals {

  private final SourceGraph graph;

  public Literals(SourceGraph graph) {
    this.graph = graph;
  }

  /** The label, English before others; the local name when there is none. */
  public String label(Node subject) {
    List<Node> labels = graph.objects(subject, RDFS.label.asNode());
    return labels.stream()
        .filter(label -> label.isLiteral() && label.getLiteralLanguage().startsWith("en"))
        .findFirst()
        .or(() -> labels.stream().filter(Node::isLiteral).findFirst())
        .map(Node::getLiteralLexicalForm)
        .orElseGet(() -> name(subject));
  }

  /** The local name of an IRI, the text of a literal, "" for a blank node. */
  public static String name(Node node) {
    if (node.isURI()) {
      return Maestro.localName(node.getURI());
    }
    return node.isLiteral() ? node.getLiteralLexicalForm() : "";
  }

  public Optional<String> text(Node subject, String property) {
    return graph.object(subject, Maestro.term(property)).map(Literals::name);
  }

  public boolean flag(Node subject, String property) {
    return text(subject, property).filter("true"::equals).isPresent();
  }

  /** Local names or texts of a property's values, lists taken apart. */
  public List<String> names(Node subject, String property) {
    return graph.objects(subject, Maestro.term(property)).stream()
        .flatMap(value -> graph.list(value).stream())
        .map(Literals::name)
        .toList();
  }

  public OptionalDouble number(Node subject, String property) {
    Node term = Maestro.term(property);
    Optional<Node> value = graph.object(subject, term);
    if (value.isEmpty()) {
      return OptionalDouble.empty();
    }
    if (term(value.get()) instanceof Term.Number number) {
      return OptionalDouble.of(number.value());
    }
    try {
      return OptionalDouble.of(Double.parseDouble(name(value.get())));
    } catch (NumberFormatException e) {
      graph.fault(subject, term, value, "is not a number", "write a number");
      return OptionalDouble.empty();
    }
  }

  /** Days to seconds. */
  public Optional<Duration> duration(Node subject, String property) {
    Node term = Maestro.term(property);
    Optional<Node> value = graph.object(subject, term);
    try {
      return value.map(Literals::name).map(Duration::parse);
    } catch (DateTimeParseException | ArithmeticException e) {
      graph.fault(
          subject, term, value, "is not a duration", "write days to seconds, such as PT10M");
      return Optional.empty();
    }
  }

  /** A literal's value, or an individual's local name. */
  public static Term term(Node node) {
    if (!node.isLiteral()) {
      return new Term.Name(name(node));
    }
    if (node.getLiteral().isWellFormed()) {
      Object value = node.getLiteralValue();
      if (value instanceof Number number) {
        return new Term.Number(number.doubleValue());
      } else if (value instanceof Boolean truth) {
        return new Term.Truth(truth);
      }
    }
    return new Term.Text(node.getLiteralLexicalForm());
  }

  public List<Term> terms(Node subject, String property) {
    List<Term> terms = new ArrayList<>();
    for (Node value : graph.objects(subject, Maestro.term(property))) {
      graph.list(value).forEach(member -> terms.add(term(member)));
    }
    return terms;
  }

  /** A MAESTRO-SL literal, parsed; a faulty one is noted and left out. */
  public <T> Optional<T> parsed(Node subject, String property, Function<String, T> parser) {
    Node term = Maestro.term(property);
    return graph.object(subject, term).flatMap(value -> parsed(subject, term, value, parser));
  }

  /** The same for one of several values. */
  public <T> Optional<T> parsed(
      Node subject, Node property, Node value, Function<String, T> parser) {
    try {
      return Optional.of(parser.apply(name(value)));
    } catch (SlSyntaxException e) {
      graph.fault(
          subject,
          property,
          Optional.of(value),
          "is not MAESTRO-SL: at column " + e.column() + " stands " + e.found(),
          "write " + e.expected() + " there");
      return Optional.empty();
    }
  }
}
