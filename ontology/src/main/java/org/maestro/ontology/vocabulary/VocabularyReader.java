package org.maestro.ontology.vocabulary;

import java.time.Duration;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.apache.jena.graph.Node;
import org.apache.jena.vocabulary.OWL;
import org.apache.jena.vocabulary.RDFS;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;
import org.maestro.sl.TypedVariable;

/** Reads classes, predicates and feature types from a graph to which inference was applied. */
public final class VocabularyReader {

  /** Classes of the meta-vocabulary that no individual of a home has. */
  private static final Set<String> ABOUT_DESCRIPTIONS =
      Set.of(
          "Predicate",
          "Fluent",
          "Observable",
          "GeometryFunction",
          "Part",
          "Feature",
          "Action",
          "Task",
          "Home",
          "Script",
          "Rule",
          "State",
          "Construction");

  /** A hundred years, beyond which clocks have no instants to reckon with. */
  private static final Duration LONGEST_AGE = Duration.ofDays(36_500);

  private final SourceGraph graph;
  private final Vocabulary known;
  private final Literals literals;
  private final Map<String, Node> named = new LinkedHashMap<>();

  public VocabularyReader(SourceGraph graph) {
    this(graph, Vocabulary.EMPTY);
  }

  /**
   * For words that come to others.
   *
   * @param known the words that are there already
   */
  public VocabularyReader(SourceGraph graph, Vocabulary known) {
    this.graph = graph;
    this.known = known;
    this.literals = new Literals(graph);
  }

  /** What the graph declares; what is wrong in it becomes faults of the graph. */
  public Vocabulary read() {
    return read(graph.subjects());
  }

  /** What the graph declares with these nodes. */
  public Vocabulary read(Collection<Node> subjects) {
    Map<String, ClassDeclaration> classes = new TreeMap<>();
    Map<String, Node> predicateNodes = new TreeMap<>();
    Map<String, Node> featureNodes = new TreeMap<>();
    for (Node subject : subjects) {
      if (!subject.isURI()) {
        continue;
      }
      String name = Literals.name(subject);
      if (isClass(subject)) {
        declare(name, subject);
        classes.put(name, classOf(subject));
      } else if (isPredicate(subject)) {
        declare(name, subject);
        predicateNodes.put(name, subject);
      } else if (FeatureReader.isFeature(graph, subject)) {
        declare(name, subject);
        featureNodes.put(name, subject);
      }
    }
    Map<String, PredicateDeclaration> predicates = new TreeMap<>();
    Set<String> fluents = new TreeSet<>();
    known.predicates().keySet().stream().filter(known::isFluent).forEach(fluents::add);
    predicateNodes.forEach(
        (name, node) -> {
          if (graph.isA(node, Maestro.term("Fluent"))) {
            fluents.add(name);
          }
        });
    predicateNodes.forEach((name, node) -> predicates.put(name, predicate(node, fluents)));
    FeatureReader features = new FeatureReader(graph, fluents::contains);
    Map<String, FeatureType> types = new TreeMap<>();
    featureNodes.forEach((name, node) -> types.put(name, features.read(node)));
    return new Vocabulary(classes, predicates, types);
  }

  private boolean isClass(Node subject) {
    return graph.isA(subject, OWL.Class.asNode())
        && !(subject.getURI().startsWith(Maestro.NAMESPACE)
            && ABOUT_DESCRIPTIONS.contains(Literals.name(subject)));
  }

  private boolean isPredicate(Node subject) {
    return graph.isA(subject, Maestro.term("Predicate"))
        || graph.isA(subject, Maestro.term("Fluent"));
  }

  private void declare(String name, Node node) {
    Node other = named.putIfAbsent(name, node);
    if (other != null && !other.equals(node)) {
      graph.fault(node, "has the local name of " + other.getURI(), "give one of both another name");
    }
    known
        .iri(name)
        .filter(iri -> !iri.equals(node.getURI()))
        .ifPresent(
            iri ->
                graph.fault(
                    node,
                    "has the local name of " + iri,
                    "give it another name, or say that it is the same"
                        + " (owl:equivalentProperty, owl:equivalentClass)"));
  }

  private ClassDeclaration classOf(Node node) {
    Set<String> ancestors = new LinkedHashSet<>(Set.of(Literals.name(node)));
    graph.objects(node, RDFS.subClassOf.asNode()).stream()
        .filter(this::isNamedClass)
        .forEach(wider -> ancestors.add(Literals.name(wider)));
    return new ClassDeclaration(
        Literals.name(node), node.getURI(), literals.label(node), ancestors);
  }

  private boolean isNamedClass(Node node) {
    return node.isURI() && (isClass(node) || isKnownClass(node));
  }

  private boolean isKnownClass(Node node) {
    ClassDeclaration declared = known.classes().get(Literals.name(node));
    return declared != null && declared.iri().equals(node.getURI());
  }

  private PredicateDeclaration predicate(Node node, Set<String> fluents) {
    String name = Literals.name(node);
    return new PredicateDeclaration(
        name,
        node.getURI(),
        literals.label(node),
        arguments(node),
        fluents.contains(name),
        graph.isA(node, Maestro.term("Observable")),
        graph.isA(node, OWL.FunctionalProperty.asNode()),
        graph.isA(node, OWL.SymmetricProperty.asNode()),
        validFor(node),
        validForByClass(node),
        formula(node, "derivedWhen", fluents).or(() -> underIt(node)),
        formula(node, "observedWhen", fluents),
        formula(node, "likelyWhen", fluents),
        graph.isA(node, Maestro.term("GeometryFunction"))
            ? Optional.of(name)
            : literals.text(node, "computedBy"),
        literals.text(node, "unit"),
        literals.number(node, "least"),
        takenFrom(node),
        formula(node, "countedWhen", fluents),
        shareOf(node),
        literals.flag(node, "private"));
  }

  private Optional<TakenFrom> takenFrom(Node node) {
    return graph
        .object(node, Maestro.term("takenFrom"))
        .map(
            from ->
                new TakenFrom(
                    literals.text(from, "property").orElse(""),
                    literals.terms(from, "numbers").stream()
                        .map(term -> term instanceof Term.Number number ? (int) number.value() : 0)
                        .toList()));
  }

  private Optional<Share> shareOf(Node node) {
    Optional<Node> share = graph.object(node, Maestro.term("shareOf"));
    Optional<Expression.Fluent> sum = share.flatMap(of -> fluent(of, "number"));
    Optional<Expression.Fluent> setting = share.flatMap(of -> fluent(of, "times"));
    if (share.isPresent() && (sum.isEmpty() || setting.isEmpty())) {
      graph.fault(
          node,
          Maestro.term("shareOf"),
          Optional.empty(),
          "does not say of what, and by which setting",
          "write such as [ maestro:number \"(illuminance ?z)\" ; maestro:times \"(level ?l)\" ]");
    }
    return sum.flatMap(of -> setting.map(by -> new Share(of, by)));
  }

  private Optional<Expression.Fluent> fluent(Node node, String property) {
    return literals
        .parsed(node, property, SlParser::expression)
        .filter(Expression.Fluent.class::isInstance)
        .map(Expression.Fluent.class::cast);
  }

  private List<TypedVariable> arguments(Node node) {
    Node property = Maestro.term("arguments");
    Optional<Node> head = graph.object(node, property);
    if (head.isEmpty()) {
      graph.fault(node, "has no maestro:arguments", "write a list such as ( \"?x - Thing\" )");
      return List.of();
    }
    return graph.list(head.get()).stream()
        .map(value -> literals.parsed(node, property, value, SlParser::variable))
        .flatMap(Optional::stream)
        .toList();
  }

  /**
   * A property without a rule of its own holds when one of the properties under it does, so that a
   * goal over it is met by them.
   */
  private Optional<Formula> underIt(Node node) {
    List<Term> variables =
        arguments(node).stream().<Term>map(p -> new Term.Variable(p.name())).toList();
    List<Formula> narrower =
        graph.subjects(RDFS.subPropertyOf.asNode(), node).stream()
            .filter(other -> !other.equals(node) && graph.isA(other, Maestro.term("Predicate")))
            .filter(other -> arguments(other).size() == variables.size())
            .<Formula>map(other -> new Formula.Atom(Literals.name(other), variables))
            .toList();
    boolean ruled =
        List.of("observedWhen", "computedBy").stream()
            .anyMatch(rule -> graph.object(node, Maestro.term(rule)).isPresent());
    return narrower.isEmpty() || ruled ? Optional.empty() : Optional.of(new Formula.Or(narrower));
  }

  private Optional<Formula> formula(Node node, String property, Set<String> fluents) {
    return literals.parsed(node, property, text -> SlParser.formula(text, fluents::contains));
  }

  private Optional<Duration> validFor(Node node) {
    Optional<Duration> age = literals.duration(node, "validFor");
    if (age.filter(given -> given.isNegative() || given.compareTo(LONGEST_AGE) > 0).isPresent()) {
      Node property = Maestro.term("validFor");
      graph.fault(
          node,
          property,
          graph.object(node, property),
          "is no age that a fact can have",
          "write up to P36500D");
      return Optional.empty();
    }
    return age;
  }

  private Map<String, Duration> validForByClass(Node node) {
    Map<String, Duration> byClass = new TreeMap<>();
    for (Node validity : graph.objects(node, Maestro.term("validity"))) {
      Optional<Duration> duration = validFor(validity);
      literals
          .text(validity, "ofClass")
          .ifPresent(name -> duration.ifPresent(age -> byClass.put(name, age)));
    }
    return byClass;
  }
}
