package org.maestro.ontology.home;

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
import org.maestro.sl.PrintedScript;
import org.maestro.sl.PrintedScriptException;
import org.maestro.sl.PrintedScriptReader;
import org.maestro.sl.SlParser;
import org.maestro.sl.TypedVariable;

/** Reads action scripts; what cannot be read becomes a fault of the graph. */
final class ScriptReader {
  static final Node ARGUMENTS = Maestro.term("arguments");
  private static final Node BODY = Maestro.term("body");
  private static final Node PRINTED = Maestro.term("printed");

  private final SourceGraph graph;
  private final Vocabulary vocabulary;
  private final Literals literals;
  private final WorthReader worth;
  private final Set<String> names;

  /**
   * @param names of all scripts
   */
  ScriptReader(SourceGraph graph, Vocabulary vocabulary, Set<String> names) {
    this.graph = graph;
    this.vocabulary = vocabulary;
    this.literals = new Literals(graph);
    this.worth = new WorthReader(graph);
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
        worth.benefit(node),
        worth.chance(node),
        worth.allowed(node),
        new ScriptedAction(graph, vocabulary).read(node, parameters));
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
}
