package org.maestro.ontology.home;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.apache.jena.graph.Node;
import org.apache.jena.vocabulary.RDF;
import org.maestro.ontology.floor.Glass;
import org.maestro.ontology.floor.Polygon;
import org.maestro.ontology.floor.Pose;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.vocabulary.Literals;
import org.maestro.ontology.vocabulary.Nearest;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Fact;
import org.maestro.sl.Self;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** Checks what a home says of its things, one by one and together on the map. */
final class HomeCheck {

  private static final double WATCHED_SHARE = 0.95;
  private static final double SAMPLE_SPACING = 0.1;
  private static final double EDGE = 1e-3;

  private static final Map<String, Consumer<String>> COORDINATES =
      Map.of(
          "pose", Pose::parse,
          "position", Pose::parse,
          "referencePoint", Pose::parse,
          "outline", Polygon::parse,
          "openingFrom", HomeCheck::corner,
          "openingTo", HomeCheck::corner,
          "glassFrom", Glass::corner,
          "glassTo", Glass::corner);

  private static final Node HAS = Maestro.term("has");

  private final SourceGraph graph;
  private final Vocabulary vocabulary;
  private final Set<String> namespaces = new TreeSet<>(Set.of(Maestro.NAMESPACE));

  HomeCheck(SourceGraph graph, Vocabulary vocabulary) {
    this.graph = graph;
    this.vocabulary = vocabulary;
    vocabulary.predicates().values().forEach(word -> namespaces.add(namespace(word.iri())));
    vocabulary.classes().values().forEach(word -> namespaces.add(namespace(word.iri())));
  }

  /** What a node says by itself: its name, classes, and the values of its properties. */
  void checkThing(Node node, boolean isDevice) {
    if (isDevice) {
      checkId(node);
    } else if (!Literals.name(node).matches("[\\p{L}\\p{N}_][\\p{L}\\p{N}_.@%+-]*")) {
      graph.fault(node, "is no name for formulas", "write letters, digits and . _ - @ % +");
    }
    checkClasses(node);
    graph.predicates(node).forEach(property -> checkProperty(node, property, true));
  }

  /**
   * A property that belongs to other classes of devices, and of which no feature of this one
   * speaks: nothing would come of it. A device of which no class says what it has may state
   * anything.
   */
  void checkUse(Node node, Device device) {
    Set<Node> own = has(graph.objects(node, RDF.type.asNode()));
    if (own.isEmpty()) {
      return;
    }
    for (Node property : graph.predicates(node)) {
      String name = Literals.name(property);
      if (!own.contains(property)
          && !graph.subjects(HAS, property).isEmpty()
          && device.features().stream().noneMatch(feature -> feature.speaksOf(name))) {
        graph.fault(
            node,
            property,
            Optional.empty(),
            "is stated in vain, as nothing of this device makes use of it",
            "remove it, or give the device a class that has it");
      }
    }
  }

  /** What a device tells of itself is not for a home to state: nothing would come of it. */
  void checkReported(Node node, Device device) {
    for (Node property : graph.predicates(node)) {
      PredicateDeclaration declared = vocabulary.predicates().get(Literals.name(property));
      if (declared == null || !declared.iri().equals(property.getURI())) {
        continue;
      }
      boolean isReported =
          device.reports().values().stream()
              .map(SlParser::fact)
              .anyMatch(fact -> isOfSelf(fact, declared.name()));
      if (isReported) {
        graph.fault(
            node,
            property,
            Optional.empty(),
            "is for the device itself to tell, whatever a home states",
            "remove it; how it is at first in a simulated world stands in the scene");
      }
    }
  }

  private static boolean isOfSelf(Fact fact, String name) {
    if (fact instanceof Fact.Equation equation) {
      return isOfSelf(equation.fluent().name(), equation.fluent().arguments(), name);
    }
    return fact instanceof Fact.Holds holds
        && isOfSelf(holds.atom().predicate(), holds.atom().arguments(), name);
  }

  private static boolean isOfSelf(String predicate, List<Term> arguments, String name) {
    return predicate.equals(name) && !arguments.isEmpty() && arguments.get(0).equals(Self.VARIABLE);
  }

  private Set<Node> has(Collection<Node> classes) {
    Set<Node> properties = new LinkedHashSet<>();
    classes.forEach(type -> properties.addAll(graph.objects(type, HAS)));
    return properties;
  }

  /** The same for a device described on its own: other things are not described with it. */
  void checkDescription(Node node) {
    checkId(node);
    checkClasses(node);
    graph.predicates(node).forEach(property -> checkProperty(node, property, false));
  }

  private void checkId(Node node) {
    if (!Literals.name(node).matches("[a-z0-9][a-z0-9-]{0,62}")) {
      graph.fault(
          node,
          "is no device id",
          "write small letters, digits and hyphens, at most 63, such as lamp-1");
    }
  }

  private void checkClasses(Node node) {
    for (Node type : graph.objects(node, RDF.type.asNode())) {
      if (isOurs(type) && !vocabulary.classes().containsKey(Literals.name(type))) {
        graph.fault(
            node,
            RDF.type.asNode(),
            Optional.of(type),
            "is no known class",
            Nearest.cure(
                Literals.name(type), vocabulary.classes().keySet(), "declare it as an owl:Class"));
      }
    }
  }

  private void checkProperty(Node node, Node property, boolean othersAreDescribed) {
    String name = Literals.name(property);
    PredicateDeclaration declared = vocabulary.predicates().get(name);
    Consumer<String> coordinates = COORDINATES.get(name);
    if (property.getURI().startsWith(Maestro.NAMESPACE) && coordinates != null) {
      graph
          .objects(node, property)
          .forEach(value -> checkCoordinates(node, property, value, coordinates));
    } else if (declared != null && declared.iri().equals(property.getURI())) {
      for (Node value : graph.objects(node, property)) {
        checkNumber(node, property, value, declared);
        if (othersAreDescribed) {
          checkOther(node, property, value, declared);
        }
      }
    } else if (isOurs(property) && !graph.isA(property, RDF.Property.asNode())) {
      graph.fault(
          node,
          property,
          Optional.empty(),
          "is no known property",
          Nearest.cure(
              name, knownProperties(), "declare it as a maestro:Predicate or maestro:Fluent"));
    }
  }

  private void checkCoordinates(
      Node node, Node property, Node value, Consumer<String> coordinates) {
    try {
      coordinates.accept(Literals.name(value));
    } catch (IllegalArgumentException e) {
      graph.fault(
          node,
          property,
          Optional.of(value),
          "is not understood: " + reason(e).replaceAll("\\.$", ""),
          "write metres with blanks between, such as "
              + (property.equals(Maestro.term("outline"))
                  ? "\"0 0, 3 0, 3 3\""
                  : "\"1.5 2\" or \"1.5 2 0.8\""));
    }
  }

  private static String reason(IllegalArgumentException e) {
    return Objects.requireNonNullElse(e.getMessage(), e.toString());
  }

  private static void corner(String text) {
    if (Pose.numbers(text).length != 2) {
      throw new IllegalArgumentException("A point on the floor is two numbers.");
    }
  }

  private void checkNumber(Node node, Node property, Node value, PredicateDeclaration declared) {
    if (declared.fluent() && !(Literals.term(value) instanceof Term.Number)) {
      graph.fault(
          node,
          property,
          Optional.of(value),
          "is not a number",
          "write a number" + declared.unit().map(unit -> " in " + unit).orElse(""));
    } else if (Literals.term(value) instanceof Term.Number number) {
      checkLeast(node, property, value, declared, OptionalDouble.of(number.value()));
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
                checkLeast(node, property, value, fluent, number);
              });
    }
  }

  private void checkLeast(
      Node node, Node property, Node value, PredicateDeclaration declared, OptionalDouble number) {
    if (number.isPresent()
        && declared.least().isPresent()
        && number.getAsDouble() < declared.least().getAsDouble()) {
      String least = SlPrinter.print(declared.least().getAsDouble()) + declared.unitAfterNumber();
      graph.fault(
          node,
          property,
          Optional.of(value),
          "is less than a %s can be".formatted(declared.label()),
          "write %s or more".formatted(least));
    }
  }

  private void checkOther(Node node, Node property, Node value, PredicateDeclaration declared) {
    if (declared.parameters().size() == 2 && value.isURI()) {
      Optional<String> wanted = declared.parameters().get(1).className();
      if (graph.objects(value, RDF.type.asNode()).isEmpty()) {
        graph.fault(
            node,
            property,
            Optional.of(value),
            "is not described in this home",
            "describe it, or name another" + wanted.map(c -> " " + c).orElse(""));
      } else if (wanted.isPresent() && !isMember(value, wanted.get())) {
        graph.fault(
            node, property, Optional.of(value), "is no " + wanted.get(), "name one that is");
      }
    }
  }

  private boolean isMember(Node node, String className) {
    return graph.objects(node, RDF.type.asNode()).stream()
        .anyMatch(
            type ->
                Literals.name(type).equals(className)
                    || vocabulary.isA(Literals.name(type), className));
  }

  /** Names in the namespaces that the vocabulary itself uses. */
  private boolean isOurs(Node node) {
    return node.isURI() && namespaces.contains(namespace(node.getURI()));
  }

  private static String namespace(String iri) {
    return iri.substring(0, iri.length() - Maestro.localName(iri).length());
  }

  private Set<String> knownProperties() {
    Set<String> names = new TreeSet<>(vocabulary.predicates().keySet());
    graph
        .subjects(RDF.type.asNode(), RDF.Property.asNode())
        .forEach(node -> names.add(Literals.name(node)));
    return names;
  }

  /** What only the whole map shows; asks for well-formed poses and outlines. */
  void checkMap(Home home, Map<String, Node> nodes) {
    Geometry geometry = new Geometry(home);
    List<Individual> zones = new ArrayList<>();
    for (Individual individual : home.individuals().values()) {
      if (individual.classes().contains("Zone")) {
        zones.add(individual);
      }
    }
    for (int i = 0; i < zones.size(); i++) {
      for (int j = i + 1; j < zones.size(); j++) {
        checkOverlap(geometry, zones.get(i).name(), zones.get(j).name(), nodes);
      }
      if (zones
          .get(i)
          .properties()
          .getOrDefault("watched", List.of())
          .contains(new Term.Truth(true))) {
        checkWatched(home, geometry, zones.get(i).name(), nodes);
      }
    }
    home.individuals().values().forEach(thing -> checkWindows(thing, home, nodes));
  }

  private void checkWindows(Individual thing, Home home, Map<String, Node> nodes) {
    if (thing.classes().contains("Window")) {
      Windows.misplacement(thing, home)
          .ifPresent(
              wrong ->
                  graph.fault(
                      named(nodes, thing.name()),
                      Maestro.term("glassFrom"),
                      Optional.empty(),
                      wrong,
                      "put its lower corner and the opposite upper one on an outer wall of one"
                          + " room"));
    }
    for (Term shaded : thing.properties().getOrDefault("shades", List.of())) {
      boolean isWindow =
          shaded instanceof Term.Name name
              && Optional.ofNullable(home.individuals().get(name.text()))
                  .filter(other -> other.classes().contains("Window"))
                  .isPresent();
      if (!isWindow) {
        graph.fault(
            named(nodes, thing.name()),
            Maestro.term("shades"),
            Optional.empty(),
            "names no window of this home",
            "name a maestro:Window");
      }
    }
  }

  /** What is kept under the name of a thing of the home: every thing has its node. */
  static <T> T named(Map<String, T> things, String name) {
    return Objects.requireNonNull(things.get(name));
  }

  private void checkOverlap(Geometry geometry, String a, String b, Map<String, Node> nodes) {
    Polygon first = geometry.outline(a).orElseThrow();
    Polygon second = geometry.outline(b).orElseThrow();
    boolean overlap =
        first.isNear(second)
            && first.samples(SAMPLE_SPACING).stream()
                .filter(second::contains)
                .anyMatch(
                    point -> second.edges().stream().allMatch(edge -> edge.distance(point) > EDGE));
    if (overlap) {
      graph.fault(
          named(nodes, b),
          Maestro.term("outline"),
          Optional.empty(),
          "overlaps the zone " + a,
          "draw the outlines so that they share at most an edge");
    }
  }

  private void checkWatched(Home home, Geometry geometry, String zone, Map<String, Node> nodes) {
    double best = 0;
    for (String device : home.devices().keySet()) {
      OptionalDouble share = geometry.viewShare(device, zone, Positions.UNKNOWN);
      best = Math.max(best, share.orElse(0));
    }
    if (best < WATCHED_SHARE) {
      graph.fault(
          named(nodes, zone),
          Maestro.term("watched"),
          Optional.empty(),
          "asks for a device that sees 95 % of the zone, and the best sees "
              + Math.round(100 * best)
              + " %",
          "move the device, widen its maestro:viewAngle, or divide the zone");
    }
  }
}
