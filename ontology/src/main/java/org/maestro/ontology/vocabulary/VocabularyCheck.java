package org.maestro.ontology.vocabulary;

import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.apache.jena.graph.Node;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.Nearest;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.sl.Expression;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.Leaves;
import org.maestro.sl.Self;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.SlSyntaxException;
import org.maestro.sl.Term;
import org.maestro.sl.TypedVariable;

/**
 * Checks that what was read speaks in declared words; every problem becomes a fault of the graph.
 */
public final class VocabularyCheck {

  private final SourceGraph graph;
  private final Vocabulary vocabulary;
  private final Predicate<String> individuals;
  private final WordHints hints;

  /**
   * @param individuals which names formulas may use for individuals
   */
  public VocabularyCheck(SourceGraph graph, Vocabulary vocabulary, Predicate<String> individuals) {
    this.graph = graph;
    this.vocabulary = vocabulary;
    this.individuals = individuals;
    this.hints = new WordHints(graph, vocabulary);
  }

  /** Checks all predicates and feature types of the graph. */
  public void check() {
    graph.subjects().forEach(this::check);
  }

  /** Checks the predicate or feature type that the node declares; any other node is none. */
  public void check(Node subject) {
    PredicateDeclaration predicate = vocabulary.predicates().get(Literals.name(subject));
    FeatureType feature = vocabulary.features().get(Literals.name(subject));
    if (predicate != null && predicate.iri().equals(iri(subject))) {
      check(subject, predicate);
    } else if (feature != null && feature.iri().equals(iri(subject))) {
      check(subject, feature);
    }
  }

  private static String iri(Node node) {
    return node.isURI() ? node.getURI() : "";
  }

  /** How many words may follow from each other one behind the other; more would take too long. */
  private static final int LONGEST_CHAIN = 20;

  /** Over how many words it follows from facts; too many when it follows from itself. */
  private int chain(String name, Set<String> above, Map<String, Integer> known) {
    Optional<Formula> rule = vocabulary.predicate(name).flatMap(PredicateDeclaration::derivedWhen);
    if (rule.isEmpty()) {
      return 0;
    }
    if (!above.add(name) || above.size() > LONGEST_CHAIN) {
      return LONGEST_CHAIN + 1;
    }
    Integer before = known.get(name);
    if (before != null) {
      above.remove(name);
      return before;
    }
    Set<String> used = new LinkedHashSet<>();
    Leaves.of(rule.get(), atom -> used.add(atom.predicate()), fluent -> used.add(fluent.name()));
    int longest = 0;
    for (String word : used) {
      longest = Math.max(longest, chain(word, above, known));
    }
    above.remove(name);
    known.put(name, longest + 1);
    return longest + 1;
  }

  private void check(Node node, PredicateDeclaration predicate) {
    if (chain(predicate.name(), new LinkedHashSet<>(), new HashMap<>()) > LONGEST_CHAIN) {
      fault(
          node,
          "derivedWhen",
          "follows from itself, or over more than " + LONGEST_CHAIN + " other words",
          "let it follow from facts");
    }
    Map<String, List<String>> variables = new LinkedHashMap<>();
    predicate
        .parameters()
        .forEach(
            parameter ->
                variables.put(
                    parameter.name(), parameter.className().map(List::of).orElse(List.of())));
    predicate.derivedWhen().ifPresent(f -> check(node, "derivedWhen", variables, c -> c.check(f)));
    predicate
        .observedWhen()
        .ifPresent(f -> check(node, "observedWhen", variables, c -> c.check(f)));
    predicate.countedWhen().ifPresent(f -> check(node, "countedWhen", variables, c -> c.check(f)));
    if (predicate.countedWhen().isPresent() && !predicate.fluent()) {
      fault(
          node,
          "countedWhen",
          "is said of what is no number",
          "declare the word as a maestro:Fluent");
    }
    predicate.likelyWhen().ifPresent(f -> check(node, "likelyWhen", variables, c -> c.check(f)));
    predicate
        .computedBy()
        .filter(function -> !graph.isA(Maestro.term(function), Maestro.term("GeometryFunction")))
        .ifPresent(
            function ->
                fault(
                    node,
                    "computedBy",
                    "is no geometry function",
                    Nearest.cure(
                        function,
                        List.of(
                            "distance",
                            "inside",
                            "viewShare",
                            "luxAt",
                            "daylightShare",
                            "sunlightShare",
                            "shortestPath",
                            "floorArea",
                            "elevation"),
                        name -> graph.written(Maestro.term(name)),
                        "write one of distance, inside, viewShare, luxAt, daylightShare,"
                            + " sunlightShare, shortestPath, floorArea, elevation")));
    predicate.takenFrom().ifPresent(from -> checkSource(node, from));
    predicate
        .shareOf()
        .ifPresent(
            share -> {
              check(node, "shareOf", variables, names -> names.check(share.number()));
              check(node, "shareOf", variables, names -> names.check(share.setting()));
              checkShare(node, predicate, share);
            });
    for (TypedVariable parameter : predicate.parameters()) {
      parameter
          .className()
          .filter(
              name ->
                  !Parameter.OWN_DATATYPES.contains(name)
                      && !vocabulary.classes().containsKey(name))
          .ifPresent(
              name ->
                  fault(
                      node,
                      "arguments",
                      "use the unknown class " + name,
                      Nearest.cure(
                          name, vocabulary.classes().keySet(), "declare it as an owl:Class")));
    }
  }

  private void checkShare(Node node, PredicateDeclaration predicate, Share share) {
    if (!predicate.fluent()) {
      fault(
          node, "shareOf", "is said of what is no number", "declare the word as a maestro:Fluent");
    } else if (!share.tellsOfAll(predicate.parameters())) {
      fault(
          node,
          "shareOf",
          "leaves an argument of the word open",
          "let each of its variables stand in maestro:number or in maestro:times");
    }
  }

  private void checkSource(Node node, TakenFrom from) {
    if (!vocabulary.predicates().containsKey(from.property())) {
      fault(
          node,
          "takenFrom",
          "names no known property (" + from.property() + ")",
          hints.cure(
              from.property(),
              vocabulary.predicates().keySet(),
              "declare it as a maestro:Predicate"));
    }
    if (from.numbers().isEmpty() || from.numbers().stream().anyMatch(number -> number < 1)) {
      fault(
          node,
          "takenFrom",
          "does not say which numbers count",
          "write maestro:numbers with a list of them, counted from 1, such as ( 1 2 )");
    }
  }

  /** Checks what a node says of a feature, of whatever device. */
  public void check(Node node, FeatureType feature) {
    check(node, feature, Set.of("Device"));
  }

  /**
   * Checks what a node says of a feature.
   *
   * @param feature with what the node leaves to its type
   * @param classes of the device that offers it
   */
  public void check(Node node, FeatureType feature, Set<String> classes) {
    Map<String, List<String>> given = new LinkedHashMap<>();
    given.put(Self.NAME, List.copyOf(classes));
    Stream.concat(feature.inputs().stream(), feature.binds().stream())
        .forEach(parameter -> given.put(parameter.name(), parameter.types()));
    Map<String, List<String>> results = new LinkedHashMap<>(given);
    feature.outputs().forEach(output -> results.put(output.name(), output.types()));
    Formula precondition = feature.precondition();
    check(node, "precondition", given, names -> names.check(precondition));
    check(node, "effect", given, names -> names.check(feature.effect()));
    feature.learns().ifPresent(e -> check(node, "learns", results, names -> names.check(e)));
    if (feature.cost() instanceof Price.Stated stated) {
      check(node, "cost", given, names -> names.check(stated.cost()));
      checkNotNegative(node, "cost", stated.cost());
    } else if (feature.cost() instanceof Price.Asked asked) {
      check(node, "costAtLeast", given, names -> names.check(asked.atLeast()));
    }
    feature
        .timing()
        .doneWhen()
        .ifPresent(f -> check(node, "doneWhen", given, names -> names.check(f)));
    feature
        .timing()
        .meanwhile()
        .ifPresent(f -> check(node, "meanwhile", given, names -> names.check(f)));
    check(node, "seconds", given, names -> names.check(feature.seconds()));
    checkNotNegative(node, "seconds", feature.seconds());
    checkFacts(node, "refersTo", given);
    checkClaims(node, feature, given);
    for (Doubt doubt : feature.doubts()) {
      check(node, "confidence", given, names -> names.check(doubt.when()));
    }
    Stream.concat(feature.inputs().stream(), feature.binds().stream())
        .forEach(parameter -> checkChoice(node, parameter));
    for (String property : List.of("input", "binds", "output")) {
      graph.objects(node, Maestro.term(property)).forEach(this::checkTypes);
    }
  }

  /** A text is no thing, so that nothing would ever come of it. */
  private void checkChoice(Node node, Parameter parameter) {
    if (parameter.isOfThings()) {
      parameter.oneOf().stream()
          .filter(value -> !(value instanceof Term.Name))
          .findFirst()
          .ifPresent(
              value ->
                  fault(
                      node,
                      "oneOf",
                      "gives %s for %s, which is to be a %s"
                          .formatted(
                              SlPrinter.print(value),
                              parameter.name(),
                              String.join(" or ", parameter.types())),
                      "write the thing, in JSON-LD as {\"id\": \"...\"}"));
    }
  }

  private void checkNotNegative(Node node, String property, Expression expression) {
    if (graph.object(node, Maestro.term(property)).isPresent()
        && expression instanceof Expression.OfTerm constant
        && constant.term() instanceof Term.Number number
        && number.value() < 0) {
      fault(
          node,
          property,
          "is less than 0 (" + SlPrinter.print(number) + ")",
          "write a number from 0 on");
    }
  }

  /**
   * Checks the facts of {@code maestro:refersTo}; a report may use its own name as a variable too.
   */
  public void checkFacts(Node node, String property, Collection<String> variables) {
    checkFacts(node, property, untyped(variables));
  }

  private static Map<String, List<String>> untyped(Collection<String> variables) {
    Map<String, List<String>> untyped = new LinkedHashMap<>();
    variables.forEach(name -> untyped.put(name, List.of()));
    return untyped;
  }

  private void checkFacts(Node node, String property, Map<String, List<String>> variables) {
    for (Node entry : graph.objects(node, Maestro.term(property))) {
      Optional<Node> text = graph.object(entry, Maestro.term("fact"));
      Map<String, List<String>> known = new LinkedHashMap<>(variables);
      graph
          .object(entry, Maestro.term("name"))
          .map(Literals::name)
          .ifPresent(name -> known.putIfAbsent(name, List.of()));
      text.flatMap(VocabularyCheck::fact)
          .ifPresent(fact -> check(entry, "fact", known, names -> names.check(fact)));
    }
  }

  private void checkClaims(Node node, FeatureType feature, Map<String, List<String>> given) {
    for (Claim claim : feature.claims()) {
      Map<String, List<String>> known = new LinkedHashMap<>(given);
      known.put(
          claim.variable().name(), claim.variable().className().map(List::of).orElse(List.of()));
      check(node, "claims", known, names -> names.check(claim.when()));
      claim
          .variable()
          .className()
          .filter(name -> !vocabulary.classes().containsKey(name))
          .ifPresent(
              name ->
                  fault(
                      node,
                      "claims",
                      "uses the unknown class " + name,
                      Nearest.cure(
                          name, vocabulary.classes().keySet(), "declare it as an owl:Class")));
    }
  }

  /** Checks a formula that the node's property states, over these variables. */
  public void checkFormula(
      Node node, String property, Collection<String> variables, Formula formula) {
    check(node, property, untyped(variables), names -> names.check(formula));
  }

  /** The same of an expression. */
  public void checkExpression(
      Node node, String property, Collection<String> variables, Expression expression) {
    check(node, property, untyped(variables), names -> names.check(expression));
  }

  /** The fact; one that cannot be read was noted when it was. */
  private static Optional<Fact> fact(Node text) {
    try {
      return Optional.of(SlParser.fact(Literals.name(text)));
    } catch (SlSyntaxException alreadyNoted) {
      return Optional.empty();
    }
  }

  /** Types are classes or datatypes. */
  private void checkTypes(Node parameter) {
    Node property = Maestro.term("type");
    for (Node value : graph.objects(parameter, property)) {
      for (Node type : graph.list(value)) {
        String name = Literals.name(type);
        boolean datatype =
            Parameter.OWN_DATATYPES.stream().map(Maestro::term).anyMatch(type::equals)
                || iri(type).startsWith("http://www.w3.org/2001/XMLSchema#");
        if (!datatype && !vocabulary.classes().containsKey(name)) {
          graph.fault(
              parameter,
              property,
              Optional.empty(),
              "names the unknown class " + name,
              hints.cure(name, vocabulary.classes().keySet(), "declare it as an owl:Class"));
        }
      }
    }
  }

  private void check(
      Node node, String property, Map<String, List<String>> variables, Consumer<NameCheck> check) {
    if (graph.object(node, Maestro.term(property)).isPresent()) {
      check.accept(
          new NameCheck(
              vocabulary,
              individuals,
              (individual, className) -> true,
              variables,
              NameCheck::declare,
              (problem, cure) -> fault(node, property, problem, cure)));
    }
  }

  private void fault(Node node, String property, String problem, String cure) {
    graph.fault(node, Maestro.term(property), Optional.empty(), problem, cure);
  }
}
