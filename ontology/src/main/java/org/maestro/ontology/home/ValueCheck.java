package org.maestro.ontology.home;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.apache.jena.graph.Node;
import org.apache.jena.vocabulary.OWL;
import org.apache.jena.vocabulary.RDF;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.vocabulary.Literals;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.ontology.vocabulary.WordHints;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;
import org.maestro.sl.TypedVariable;

/** Checks what is stated of a thing under one property that the vocabulary declares. */
final class ValueCheck {

  private final SourceGraph graph;
  private final Vocabulary vocabulary;
  private final WordHints hints;
  private final Node node;
  private final Node property;
  private final PredicateDeclaration declared;

  ValueCheck(
      SourceGraph graph,
      Vocabulary vocabulary,
      Node node,
      Node property,
      PredicateDeclaration declared) {
    this.graph = graph;
    this.vocabulary = vocabulary;
    this.hints = new WordHints(graph, vocabulary);
    this.node = node;
    this.property = property;
    this.declared = declared;
  }

  /** What can be said of values by themselves. */
  void checkNumbers() {
    graph.objects(node, property).forEach(this::checkNumber);
  }

  /** What can be said where other things are described too. */
  void checkInHome() {
    for (Node value : graph.objects(node, property)) {
      checkOther(value);
      checkTruth(value);
    }
    checkSubject();
    checkRepeated();
    checkDerived();
  }

  private void checkNumber(Node value) {
    if (declared.fluent() && !(Literals.term(value) instanceof Term.Number)) {
      graph.fault(
          node,
          property,
          Optional.of(value),
          "is not a number",
          "write a number" + declared.unit().map(unit -> " in " + unit).orElse(""));
    } else if (Literals.term(value) instanceof Term.Number number) {
      checkLeast(value, declared, OptionalDouble.of(number.value()));
    }
    for (PredicateDeclaration fluent : vocabulary.predicates().values()) {
      fluent
          .takenFrom()
          .filter(from -> from.property().equals(declared.name()))
          .ifPresent(
              from -> {
                OptionalDouble number = from.number(Literals.term(value));
                if (number.isEmpty()) {
                  graph.fault(
                      node,
                      property,
                      Optional.of(value),
                      "does not tell the %s (of its numbers, %s)"
                          .formatted(
                              fluent.label(),
                              from.numbers().stream()
                                  .map(String::valueOf)
                                  .collect(Collectors.joining(" and "))),
                      "write numbers with blanks between, such as \"0.1 0.08 0.12\"");
                }
                checkLeast(value, fluent, number);
              });
    }
  }

  private void checkLeast(Node value, PredicateDeclaration meant, OptionalDouble number) {
    if (number.isPresent()
        && meant.least().isPresent()
        && number.getAsDouble() < meant.least().getAsDouble()) {
      String least = SlPrinter.print(meant.least().getAsDouble()) + meant.unitAfterNumber();
      graph.fault(
          node,
          property,
          Optional.of(value),
          "is less than a %s can be".formatted(meant.label()),
          "write %s or more".formatted(least));
    }
  }

  private void checkOther(Node value) {
    if (declared.parameters().size() != 2) {
      return;
    }
    Optional<String> wanted = declared.parameters().get(1).className();
    if (value.isURI()) {
      if (graph.objects(value, RDF.type.asNode()).isEmpty()) {
        graph.fault(
            node,
            property,
            Optional.of(value),
            "is not described in this home",
            "describe it, or name another" + wanted.map(c -> " " + hints.written(c)).orElse(""));
      } else if (wanted.isPresent() && !isMember(value, wanted.get())) {
        graph.fault(
            node, property, Optional.of(value), "is no " + wanted.get(), "name one that is");
      }
    } else if (value.isLiteral() && wanted.filter(vocabulary.classes()::containsKey).isPresent()) {
      graph.fault(
          node,
          property,
          Optional.of(value),
          "is a text or number, where a " + hints.written(wanted.get()) + " is wanted",
          "write its name without quotes, with the prefix of the home's things");
    }
  }

  /** What has no second argument is true or false. */
  private void checkTruth(Node value) {
    if (!declared.fluent()
        && declared.parameters().size() == 1
        && !(Literals.term(value) instanceof Term.Truth)) {
      graph.fault(
          node,
          property,
          Optional.of(value),
          "is neither true nor false",
          "write one of both, without quotes");
    }
  }

  private void checkSubject() {
    List<Node> types = graph.objects(node, RDF.type.asNode());
    if (types.isEmpty()
        || !types.stream().map(Literals::name).allMatch(vocabulary.classes()::containsKey)) {
      return;
    }
    declared.parameters().stream()
        .findFirst()
        .flatMap(TypedVariable::className)
        .filter(vocabulary.classes()::containsKey)
        .filter(wanted -> !isMember(node, wanted))
        .ifPresent(
            wanted ->
                graph.fault(
                    node,
                    property,
                    Optional.empty(),
                    "is said of what is no " + hints.written(wanted),
                    "remove it, or give " + Literals.name(node) + " such a class"));
  }

  private void checkRepeated() {
    boolean hasOne =
        declared.parameters().size() == 1
            || graph.isA(property, OWL.FunctionalProperty.asNode())
            || vocabulary.predicates().values().stream()
                .flatMap(fluent -> fluent.takenFrom().stream())
                .anyMatch(from -> from.property().equals(declared.name()));
    if (hasOne && graph.objects(node, property).size() > 1) {
      graph.fault(
          node, property, Optional.empty(), "is stated more than once", "keep one of the values");
    }
  }

  private void checkDerived() {
    if (declared.derivedWhen().isPresent()) {
      graph.fault(
          node,
          property,
          Optional.empty(),
          "follows from other facts, whatever a home states",
          "remove it, and state those facts");
    }
  }

  private boolean isMember(Node node, String className) {
    return graph.objects(node, RDF.type.asNode()).stream()
        .anyMatch(
            type ->
                Literals.name(type).equals(className)
                    || vocabulary.isA(Literals.name(type), className));
  }
}
