package org.maestro.ontology.home;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.apache.jena.graph.Node;
import org.apache.jena.vocabulary.RDF;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.vocabulary.Literals;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Body;
import org.maestro.sl.Expression;
import org.maestro.sl.PrintedScript;
import org.maestro.sl.PrintedScriptException;
import org.maestro.sl.PrintedScriptReader;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;
import org.maestro.sl.TypedVariable;

/** Reads action scripts; what cannot be read becomes a fault of the graph. */
final class ScriptReader {
  static final Node ARGUMENTS = Maestro.term("arguments");
  private static final Node BODY = Maestro.term("body");
  private static final Node PRINTED = Maestro.term("printed");

  private final SourceGraph graph;
  private final Vocabulary vocabulary;
  private final Literals literals;
  private final Set<String> names;

  /**
   * @param names of all scripts
   */
  ScriptReader(SourceGraph graph, Vocabulary vocabulary, Set<String> names) {
    this.graph = graph;
    this.vocabulary = vocabulary;
    this.literals = new Literals(graph);
    this.names = names;
  }

  static boolean isScript(SourceGraph graph, Node node) {
    return graph.isA(node, Maestro.term("Script"));
  }

  /** The script; one without a body that can be read has no steps, and its fault is noted. */
  Script read(Node node) {
    if (graph.objects(node, RDF.type.asNode()).size() > 1) {
      graph.fault(
          node, "is a script and something else as well", "give the script a name of its own");
    }
    List<TypedVariable> parameters = parameters(node);
    return new Script(
        Literals.name(node),
        literals.label(node),
        parameters,
        body(node, parameters).orElse(new Body.Seq(List.of())),
        benefit(node),
        chance(node),
        allowed(node));
  }

  /** The property that states a script's steps. */
  static Node steps(SourceGraph graph, Node node) {
    return graph.object(node, PRINTED).isPresent() ? PRINTED : BODY;
  }

  private Optional<Body> body(Node node, List<TypedVariable> parameters) {
    boolean isInSl = graph.object(node, BODY).isPresent();
    Optional<Node> printed = graph.object(node, PRINTED);
    if (printed.isPresent()) {
      if (isInSl) {
        fault(node, "is stated beside maestro:body", "keep one of both");
      }
      return printed(node, Literals.name(printed.get()), parameters);
    }
    if (!isInSl) {
      graph.fault(
          node,
          BODY,
          Optional.empty(),
          "is missing",
          "write the steps in MAESTRO-SL in quotes, such as \"(achieve (in Cup zone-a))\"");
    }
    return literals.parsed(node, "body", text -> SlParser.body(text, vocabulary::isFluent));
  }

  private Optional<Body> printed(Node node, String text, List<TypedVariable> parameters) {
    try {
      PrintedScript script = PrintedScriptReader.read(text, names::contains);
      checkHead(node, script, parameters.stream().map(TypedVariable::name).toList());
      return Optional.of(script.body());
    } catch (PrintedScriptException e) {
      fault(node, "in line %d %s".formatted(e.line(), e.problem()), e.cure());
      return Optional.empty();
    }
  }

  private void checkHead(Node node, PrintedScript script, List<String> parameters) {
    String name = Literals.name(node);
    if (!script.name().equals(name)) {
      fault(node, "is headed by script: " + script.name(), "write script: " + name);
    }
    if (!script.agents().equals(parameters)) {
      fault(
          node,
          "declares the agents (%s), and maestro:arguments (%s)"
              .formatted(String.join(", ", script.agents()), String.join(", ", parameters)),
          "name the same in both, in one order, in maestro:arguments with their classes");
    }
  }

  private void fault(Node node, String problem, String cure) {
    graph.fault(node, PRINTED, Optional.empty(), problem, cure);
  }

  private List<TypedVariable> parameters(Node node) {
    return graph.objects(node, ARGUMENTS).stream()
        .flatMap(list -> graph.list(list).stream())
        .map(value -> literals.parsed(node, ARGUMENTS, value, ScriptReader::parameter))
        .flatMap(Optional::stream)
        .toList();
  }

  /** A datatype may have the prefix that it has elsewhere in the file. */
  private static TypedVariable parameter(String text) {
    return SlParser.variable(text.replaceFirst("-\\s+xsd:", "- "));
  }

  private Optional<Expression> benefit(Node node) {
    Optional<Expression> benefit = literals.parsed(node, "benefit", SlParser::expression);
    if (benefit.isPresent()
        && benefit.get() instanceof Expression.OfTerm constant
        && constant.term() instanceof Term.Number number
        && number.value() < 0) {
      Node property = Maestro.term("benefit");
      graph.fault(
          node,
          property,
          graph.object(node, property),
          "is less than nothing",
          "write the seconds of work that it is worth, such as 60");
    }
    return benefit;
  }

  /** What is no number from 0 to 1 was noted when the shapes were checked. */
  private Optional<Double> chance(Node node) {
    return graph
        .object(node, Maestro.term("chance"))
        .map(Literals::term)
        .filter(Term.Number.class::isInstance)
        .map(term -> ((Term.Number) term).value());
  }

  private Optional<Duration> allowed(Node node) {
    Optional<Duration> allowed = literals.duration(node, "allowed");
    if (allowed.filter(time -> time.isNegative() || time.isZero()).isPresent()) {
      Node property = Maestro.term("allowed");
      graph.fault(
          node,
          property,
          graph.object(node, property),
          "leaves no time",
          "write days to seconds, such as PT10M");
    }
    return allowed;
  }
}
