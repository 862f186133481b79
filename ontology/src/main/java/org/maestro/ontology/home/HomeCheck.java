package org.maestro.ontology.home;

import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import org.apache.jena.graph.Node;
import org.apache.jena.vocabulary.OWL;
import org.apache.jena.vocabulary.RDF;
import org.maestro.ontology.floor.Glass;
import org.maestro.ontology.floor.Polygon;
import org.maestro.ontology.floor.Pose;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.vocabulary.Literals;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.ontology.vocabulary.WordHints;
import org.maestro.sl.Fact;
import org.maestro.sl.Self;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

/** Checks what a home says of its things, one by one and together on the map. */
final class HomeCheck {

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
  private static final List<Node> PROPERTIES =
      List.of(RDF.Property.asNode(), OWL.ObjectProperty.asNode(), OWL.DatatypeProperty.asNode());

  private final SourceGraph graph;
  private final Vocabulary vocabulary;
  private final WordHints hints;
  private final Set<String> namespaces = new TreeSet<>(Set.of(Maestro.NAMESPACE));

  HomeCheck(SourceGraph graph, Vocabulary vocabulary) {
    this.graph = graph;
    this.vocabulary = vocabulary;
    this.hints = new WordHints(graph, vocabulary);
    vocabulary.predicates().values().forEach(word -> namespaces.add(namespace(word.iri())));
    vocabulary.classes().values().forEach(word -> namespaces.add(namespace(word.iri())));
  }

  /** What a node says by itself: its name, classes, and the values of its properties. */
  void checkThing(Node node, boolean isDevice) {
    if (isDevice) {
      checkId(node);
    } else {
      checkName(node);
    }
    checkClasses(node);
    checkProperties(node);
  }

  /** The same of a script, which is no thing. */
  void checkScript(Node node) {
    checkName(node);
    checkProperties(node);
  }

  private void checkName(Node node) {
    if (!Literals.name(node).matches("[\\p{L}\\p{N}_][\\p{L}\\p{N}_.@%+-]*")) {
      graph.fault(node, "is no name for formulas", "write letters, digits and . _ - @ % +");
    }
  }

  private void checkProperties(Node node) {
    graph.predicates(node).forEach(property -> checkProperty(node, property, true));
  }

  /** That a home says what the thing is, and declares those words that only it can declare. */
  void checkHomeDeclares(Node node) {
    if (graph.objects(node, RDF.type.asNode()).isEmpty()) {
      graph.fault(
          node,
          "has no class",
          "write what it is, such as a %s, or correct its name".formatted(hints.written("Thing")));
    }
    graph.predicates(node).stream()
        .filter(property -> namespace(property.getURI()).equals(namespace(node.getURI())))
        .filter(
            property ->
                vocabulary
                    .predicate(Literals.name(property))
                    .filter(declared -> declared.iri().equals(property.getURI()))
                    .isEmpty())
        .forEach(property -> checkDeclared(node, property));
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
      if (isOurs(type) && !isAClass(type)) {
        graph.fault(
            node,
            RDF.type.asNode(),
            Optional.of(type),
            "is no known class",
            hints.cure(
                Literals.name(type), vocabulary.classes().keySet(), "declare it as an owl:Class"));
      }
    }
  }

  private boolean isAClass(Node type) {
    return Optional.ofNullable(vocabulary.classes().get(Literals.name(type)))
        .filter(declared -> declared.iri().equals(type.getURI()))
        .isPresent();
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
      ValueCheck values = new ValueCheck(graph, vocabulary, node, property, declared);
      values.checkNumbers();
      if (othersAreDescribed) {
        values.checkInHome();
      }
    } else if (isOurs(property)) {
      checkDeclared(node, property);
    }
  }

  private void checkDeclared(Node node, Node property) {
    if (PROPERTIES.stream().noneMatch(kind -> graph.isA(property, kind))) {
      graph.fault(
          node,
          property,
          Optional.empty(),
          "is no known property",
          hints.cure(
              Literals.name(property),
              knownProperties(),
              "declare it as a maestro:Predicate or maestro:Fluent"));
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

  /** What is kept under the name of a thing of the home: every thing has its node. */
  static <T> T named(Map<String, T> things, String name) {
    return Objects.requireNonNull(things.get(name));
  }
}
