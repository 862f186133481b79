package org.maestro.ontology.home;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.BiConsumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.apache.jena.graph.Node;
import org.apache.jena.graph.NodeFactory;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.Nearest;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Literals;
import org.maestro.ontology.vocabulary.NameCheck;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.ontology.vocabulary.WordHints;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * Checks permissions of persons: that there are the persons, that the devices which are named can
 * do what is named, and that the condition speaks of the parameters of that. What limits nobody by
 * a slip would be a door left open.
 */
final class PersonalPermissionCheck {
  private static final String WHEN = "when";

  private final SourceGraph graph;
  private final Home home;
  private final WordHints hints;
  private final Set<String> persons = new TreeSet<>(Set.of(Permission.ANYBODY));

  PersonalPermissionCheck(SourceGraph graph, Home home) {
    this.graph = graph;
    this.home = home;
    this.hints = new WordHints(graph, home.vocabulary());
    home.individuals().values().stream()
        .filter(PersonalPermission::isPerson)
        .map(Individual::name)
        .forEach(persons::add);
    home.vocabulary().classes().keySet().stream()
        .filter(name -> PersonalPermission.isOfPersons(name, home.vocabulary()))
        .forEach(persons::add);
  }

  void check(Node node, Individual stated) {
    if (!PersonalPermission.isOne(stated)) {
      if (graph.objects(node, Maestro.term("caller")).isEmpty()) {
        fault(
            node,
            "caller",
            "is missing",
            "write who may ask, such as \"tablet\", or \"*\" for everybody; or maestro:person,"
                + " where it is about a person");
      }
      Stream.of("forbids", WHEN)
          .filter(property -> !graph.objects(node, Maestro.term(property)).isEmpty())
          .forEach(
              property ->
                  fault(
                      node,
                      property,
                      "is said of persons only",
                      "add maestro:person, or leave it away"));
      return;
    }
    Stream.of("caller", "reads", "opens")
        .filter(property -> !graph.objects(node, Maestro.term(property)).isEmpty())
        .forEach(
            property ->
                fault(
                    node,
                    property,
                    "is said of agents and users, and the permission is one of persons",
                    "state two permissions"));
    checkPersons(node);
    Literals literals = new Literals(graph);
    Optional<Formula> when =
        literals.parsed(node, WHEN, text -> SlParser.formula(text, home.vocabulary()::isFluent));
    boolean isReadable = when.isPresent() || literals.text(node, WHEN).isEmpty();
    if (isReadable) {
      check(node, PersonalPermission.read(stated, home));
    }
  }

  private void checkPersons(Node node) {
    Node property = Maestro.term("person");
    for (Node value : graph.objects(node, property)) {
      if (!persons.contains(Literals.name(value))) {
        graph.fault(
            node,
            property,
            Optional.of(value),
            "is neither a person of this home nor a class of persons",
            Nearest.cure(
                Literals.name(value),
                persons,
                this::written,
                "name one of %s, or write \"*\" for everybody"
                    .formatted(
                        persons.stream()
                            .filter(name -> !name.equals(Permission.ANYBODY))
                            .collect(Collectors.joining(", ")))));
      }
    }
  }

  private String written(String name) {
    return Optional.ofNullable(home.individuals().get(name))
        .map(person -> graph.written(NodeFactory.createURI(person.iri())))
        .orElseGet(() -> hints.written(name));
  }

  private void check(Node node, PersonalPermission permission) {
    checkOffered(node, permission);
    permission.when().ifPresent(when -> checkCondition(node, permission, when));
  }

  /** A device that cannot do it is not limited in it. */
  private void checkOffered(Node node, PersonalPermission permission) {
    List<Device> named =
        permission.asks().stream()
            .flatMap(name -> Optional.ofNullable(home.devices().get(name)).stream())
            .toList();
    boolean areAllNamed = named.size() == permission.asks().size() && !named.isEmpty();
    for (String property : List.of("permits", "forbids")) {
      Set<String> features =
          property.equals("permits") ? permission.permits() : permission.forbids();
      for (String feature : features) {
        boolean isOffered =
            feature.equals(PersonalPermission.ANY_FEATURE)
                || named.stream()
                    .flatMap(device -> device.features().stream())
                    .anyMatch(offered -> offered.name().equals(feature));
        if (areAllNamed && !isOffered) {
          fault(
              node,
              property,
              "names %s, which %s does not offer"
                  .formatted(
                      feature, named.stream().map(Device::id).collect(Collectors.joining(" or "))),
              Nearest.cure(
                  feature,
                  named.stream()
                      .flatMap(device -> device.features().stream())
                      .map(FeatureType::name)
                      .toList(),
                  hints::written,
                  "name another one, or other devices"));
        }
      }
    }
  }

  /** The condition has to make sense for each feature of which it is stated. */
  private void checkCondition(Node node, PersonalPermission permission, Formula when) {
    Set<String> told = new HashSet<>();
    BiConsumer<String, String> problems =
        (problem, cure) -> {
          if (told.add(problem)) {
            fault(node, WHEN, problem, cure);
          }
        };
    List<FeatureType> features = features(permission);
    if (features.isEmpty()) {
      check(when, variables(Optional.empty()), problems);
    }
    features.forEach(feature -> check(when, variables(Optional.of(feature)), problems));
  }

  private List<FeatureType> features(PersonalPermission permission) {
    List<FeatureType> offered =
        home.devices().values().stream()
            .filter(permission::isAbout)
            .flatMap(device -> device.features().stream())
            .distinct()
            .filter(
                feature ->
                    permission.permits().contains(feature.name())
                        || permission.forbids().contains(feature.name()))
            .toList();
    return offered.isEmpty()
        ? home.vocabulary().features().values().stream()
            .filter(
                feature ->
                    permission.permits().contains(feature.name())
                        || permission.forbids().contains(feature.name()))
            .toList()
        : offered;
  }

  /** Of the device and who asks the class is not known. */
  private static Map<String, List<String>> variables(Optional<FeatureType> feature) {
    Map<String, List<String>> variables = new HashMap<>();
    variables.put("self", List.of());
    variables.put(PersonalPermission.SPEAKER, List.of());
    feature.ifPresent(
        one ->
            Stream.concat(one.inputs().stream(), one.binds().stream())
                .forEach(parameter -> variables.put(parameter.name(), parameter.types())));
    return variables;
  }

  private void check(
      Formula when, Map<String, List<String>> variables, BiConsumer<String, String> problems) {
    new NameCheck(
            home.vocabulary(),
            home.individuals()::containsKey,
            (name, className) ->
                HomeCheck.named(home.individuals(), name).classes().contains(className),
            variables,
            NameCheck::declare,
            problems)
        .check(when);
    checkNumbers(when, variables, problems);
  }

  /** What is compared with a number is one. */
  private static void checkNumbers(
      Formula formula, Map<String, List<String>> variables, BiConsumer<String, String> problems) {
    if (formula instanceof Formula.Comparison comparison) {
      checkNumber(comparison.left(), comparison.right(), variables, problems);
      checkNumber(comparison.right(), comparison.left(), variables, problems);
    }
    formula.parts().forEach(part -> checkNumbers(part, variables, problems));
  }

  private static void checkNumber(
      Expression one,
      Expression other,
      Map<String, List<String>> variables,
      BiConsumer<String, String> problems) {
    boolean isWithNumber =
        !(other instanceof Expression.OfTerm term) || term.term() instanceof Term.Number;
    if (isWithNumber
        && one instanceof Expression.OfTerm ofTerm
        && ofTerm.term() instanceof Term.Variable variable) {
      List<String> types = variables.getOrDefault(variable.name(), List.of());
      boolean isNone = !types.isEmpty() && types.stream().noneMatch(Parameter::isNumber);
      if (isNone) {
        problems.accept(
            "compares ?%s, a %s, with %s"
                .formatted(variable.name(), String.join(" or ", types), SlPrinter.print(other)),
            "name a parameter that is a number");
      }
    }
  }

  private void fault(Node node, String property, String problem, String cure) {
    Node term = Maestro.term(property);
    graph.fault(node, term, graph.object(node, term), problem, cure);
  }
}
