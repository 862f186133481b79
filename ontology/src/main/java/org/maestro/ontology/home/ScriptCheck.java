package org.maestro.ontology.home;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.apache.jena.graph.Node;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.Nearest;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.NameCheck;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.sl.TypedVariable;

/** Checks the scripts of a home: each by itself, and that they end. */
final class ScriptCheck {
  private final SourceGraph graph;
  private final Home home;

  ScriptCheck(SourceGraph graph, Home home) {
    this.graph = graph;
    this.home = home;
  }

  void check(Map<String, Node> nodes) {
    if (nodes.isEmpty()) {
      return;
    }
    Offers offers = new Offers(graph, home);
    nodes.forEach((name, node) -> check(node, HomeCheck.named(home.scripts(), name), offers));
  }

  private void check(Node node, Script script, Offers offers) {
    checkParameters(node, script.parameters());
    Map<String, List<String>> variables = new HashMap<>();
    script
        .parameters()
        .forEach(parameter -> variables.put(parameter.name(), BodyCheck.classes(parameter)));
    BodyCheck ofBenefit =
        new BodyCheck(
            home, offers, (problem, cure) -> fault(node, Maestro.term("benefit"), problem, cure));
    script.benefit().ifPresent(benefit -> ofBenefit.names(variables).check(benefit));
    script.action().ifPresent(action -> check(node, action, offers, variables));
    Node steps = ScriptReader.steps(graph, node);
    new BodyCheck(home, offers, (problem, cure) -> fault(node, steps, problem, cure))
        .check(script.body(), variables);
    List<String> endless = EndlessRuns.from(script.name(), home.scripts());
    if (!endless.isEmpty()) {
      fault(
          node,
          steps,
          "runs itself without an end (%s)".formatted(String.join(", ", endless)),
          "put one of these runs under a condition, such as (if ... (run %s ...))"
              .formatted(endless.get(1)));
    }
  }

  /** The action as which plans use the script speaks of its arguments only. */
  private void check(
      Node node, FeatureType action, Offers offers, Map<String, List<String>> variables) {
    names(node, "precondition", offers, variables).check(action.precondition());
    names(node, "effect", offers, variables).check(action.effect());
    if (action.cost() instanceof Price.Stated stated) {
      names(node, "cost", offers, variables).check(stated.cost());
    }
    if (home.devices().containsKey(Script.PLANNED_AS)) {
      fault(
          node,
          Maestro.term("effect"),
          "is used in plans under the name %s, which a device has".formatted(Script.PLANNED_AS),
          "give the device another name");
    }
  }

  private NameCheck names(
      Node node, String property, Offers offers, Map<String, List<String>> variables) {
    return new BodyCheck(
            home, offers, (problem, cure) -> fault(node, Maestro.term(property), problem, cure))
        .names(variables);
  }

  private void checkParameters(Node node, List<TypedVariable> parameters) {
    Set<String> known = new TreeSet<>(home.vocabulary().classes().keySet());
    Set<String> names = new TreeSet<>();
    for (TypedVariable parameter : parameters) {
      if (!names.add(parameter.name())) {
        fault(
            node,
            ScriptReader.ARGUMENTS,
            "names ?%s twice".formatted(parameter.name()),
            "give one of both another name");
      }
      if (parameter.className().isEmpty()) {
        fault(
            node,
            ScriptReader.ARGUMENTS,
            "does not say what ?%s is".formatted(parameter.name()),
            "write its class or datatype, such as \"?%s - Thing\"".formatted(parameter.name()));
      }
      parameter
          .className()
          .filter(type -> !Parameter.isDatatype(type) && !known.contains(type))
          .ifPresent(
              type ->
                  fault(
                      node,
                      ScriptReader.ARGUMENTS,
                      "use the unknown class " + type,
                      Nearest.cure(type, known, "declare it as an owl:Class")));
    }
  }

  private void fault(Node node, Node property, String problem, String cure) {
    graph.fault(node, property, Optional.empty(), problem, cure);
  }
}
