package org.maestro.ontology.validation;

import java.io.StringWriter;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.Function;
import java.util.function.Predicate;
import org.apache.jena.graph.Graph;
import org.apache.jena.graph.Node;
import org.apache.jena.graph.Triple;
import org.apache.jena.riot.Lang;
import org.apache.jena.riot.RDFDataMgr;
import org.apache.jena.sparql.graph.GraphFactory;
import org.apache.jena.vocabulary.RDF;

/**
 * Statements in the order in which the texts state them, each with its origin, and the faults found
 * in them so far. Not safe for threads; a reader makes one, fills it and drops it.
 */
public final class SourceGraph {

  /** The source and line of a statement. */
  record Origin(String source, int line) {}

  private final Map<Triple, Origin> origins = new LinkedHashMap<>();
  private final Map<Node, Map<Node, List<Node>>> bySubject = new LinkedHashMap<>();
  private final Map<Node, Map<Node, List<Node>>> byObject = new LinkedHashMap<>();
  private final Map<String, String> prefixes = new LinkedHashMap<>();
  private final Map<String, String> usualPrefixes = new LinkedHashMap<>();
  private final Set<Triple> inferred = new LinkedHashSet<>();
  private final Set<Fault> faults = new LinkedHashSet<>();

  /** Adds what follows from a statement of this origin. */
  void infer(Triple triple, Origin origin) {
    if (!origins.containsKey(triple)) {
      inferred.add(triple);
      add(triple, origin);
    }
  }

  /** Whether a text states it, rather than that it follows from others. */
  public boolean isStated(Node subject, Node predicate, Node object) {
    Triple triple = Triple.create(subject, predicate, object);
    return origins.containsKey(triple) && !inferred.contains(triple);
  }

  /** Copies the other graph's statements that pass, with their origins. */
  public void copy(SourceGraph other, Predicate<Triple> wanted) {
    other.origins.forEach(
        (triple, origin) -> {
          if (wanted.test(triple)) {
            add(triple, origin);
          }
        });
  }

  /**
   * Copies what the other graph's statements mean, with their origins.
   *
   * @param meaning empty: the statement is left away
   */
  public void copyMapped(SourceGraph other, Function<Triple, Optional<Triple>> meaning) {
    other.origins.forEach(
        (triple, origin) -> meaning.apply(triple).ifPresent(meant -> add(meant, origin)));
  }

  /** Copies those statements of one text of the other graph that pass. */
  public void copyOf(String source, SourceGraph other, Predicate<Triple> wanted) {
    other.origins.forEach(
        (triple, origin) -> {
          if (origin.source().equals(source) && wanted.test(triple)) {
            add(triple, origin);
          }
        });
  }

  /**
   * The same texts with other statements in the place of theirs, at the same lines; without what
   * was inferred.
   *
   * @param other empty: the statement is left away
   */
  public SourceGraph mapped(Function<Triple, Optional<Triple>> other) {
    SourceGraph mapped = new SourceGraph();
    mapped.copyPrefixes(this);
    mapped.faults.addAll(faults);
    origins.forEach(
        (triple, origin) -> {
          if (!inferred.contains(triple)) {
            other.apply(triple).ifPresent(meant -> mapped.add(meant, origin));
          }
        });
    return mapped;
  }

  /** Copies what the other graph says of a subject, and of the blank nodes that belong to it. */
  public void copyAbout(Node subject, SourceGraph other) {
    if (!bySubject.containsKey(subject) || !subject.isBlank()) {
      copy(other, triple -> triple.getSubject().equals(subject));
      other.bySubject.getOrDefault(subject, Map.of()).values().stream()
          .flatMap(List::stream)
          .filter(Node::isBlank)
          .forEach(blank -> copyAbout(blank, other));
    }
  }

  /**
   * Copies what a text of the other graph states of a subject, and of the blank nodes that belong
   * to it.
   */
  public void copyStated(Node subject, String source, SourceGraph other) {
    if (bySubject.containsKey(subject)) {
      return;
    }
    other
        .bySubject
        .getOrDefault(subject, Map.of())
        .forEach(
            (predicate, objects) ->
                objects.forEach(
                    object -> {
                      Triple triple = Triple.create(subject, predicate, object);
                      Origin origin = other.originOf(triple);
                      if (origin.source().equals(source) && !other.inferred.contains(triple)) {
                        add(triple, origin);
                      }
                    }));
    bySubject.getOrDefault(subject, Map.of()).values().stream()
        .flatMap(List::stream)
        .filter(Node::isBlank)
        .toList()
        .forEach(blank -> copyStated(blank, source, other));
  }

  void add(Triple triple, Origin origin) {
    if (origins.putIfAbsent(triple, origin) == null) {
      bySubject
          .computeIfAbsent(triple.getSubject(), subject -> new LinkedHashMap<>())
          .computeIfAbsent(triple.getPredicate(), predicate -> new ArrayList<>())
          .add(triple.getObject());
      byObject
          .computeIfAbsent(triple.getObject(), object -> new LinkedHashMap<>())
          .computeIfAbsent(triple.getPredicate(), predicate -> new ArrayList<>())
          .add(triple.getSubject());
    }
  }

  /** Adds a statement that no text makes. */
  public void state(Node subject, Node property, Node value) {
    add(Triple.create(subject, property, value), new Origin("", 0));
  }

  boolean contains(Triple triple) {
    return origins.containsKey(triple);
  }

  void forEach(BiConsumer<Triple, Origin> action) {
    origins.forEach(action);
  }

  /** The statements as Turtle. */
  public String turtle() {
    Graph graph = toGraph();
    prefixes.forEach(
        (namespace, prefix) -> graph.getPrefixMapping().setNsPrefix(prefix, namespace));
    StringWriter text = new StringWriter();
    RDFDataMgr.write(text, graph, Lang.TURTLE);
    return text.toString();
  }

  /** Has names shortened as the other graph's texts do. */
  public void copyPrefixes(SourceGraph other) {
    other.prefixes.forEach(prefixes::putIfAbsent);
    other.usualPrefixes.forEach(usualPrefixes::putIfAbsent);
  }

  /** A prefix that the text may use, though it does not declare it by itself. */
  void usualPrefix(String prefix, String namespace) {
    usualPrefixes.putIfAbsent(namespace, prefix);
  }

  /** The text read last decides: its reader is told of names as that text writes them. */
  void prefix(String prefix, String namespace) {
    prefixes.values().removeIf(prefix::equals);
    prefixes.put(namespace, prefix);
  }

  /** A Jena graph of all statements. */
  Graph toGraph() {
    Graph graph = GraphFactory.createDefaultGraph();
    origins.keySet().forEach(graph::add);
    return graph;
  }

  /** Everything that something is said of, in order of first mention. */
  public Set<Node> subjects() {
    return bySubject.keySet();
  }

  /** Subjects that the texts of this source speak of, in order. */
  public Set<Node> subjectsOf(String source) {
    Set<Node> subjects = new LinkedHashSet<>();
    origins.forEach(
        (triple, origin) -> {
          if (origin.source().equals(source)) {
            subjects.add(triple.getSubject());
          }
        });
    return subjects;
  }

  public Set<Node> predicates(Node subject) {
    return bySubject.getOrDefault(subject, Map.of()).keySet();
  }

  public List<Node> objects(Node subject, Node predicate) {
    return bySubject.getOrDefault(subject, Map.of()).getOrDefault(predicate, List.of());
  }

  public Optional<Node> object(Node subject, Node predicate) {
    return objects(subject, predicate).stream().findFirst();
  }

  public List<Node> subjects(Node predicate, Node object) {
    return byObject.getOrDefault(object, Map.of()).getOrDefault(predicate, List.of());
  }

  /** Everything of which this is said, in order of first mention. */
  public List<Node> subjectsWith(Node predicate) {
    return bySubject.entrySet().stream()
        .filter(entry -> entry.getValue().containsKey(predicate))
        .map(Map.Entry::getKey)
        .toList();
  }

  public boolean isA(Node subject, Node type) {
    return objects(subject, RDF.type.asNode()).contains(type);
  }

  /** The members of an RDF list; the node itself as the only member when it is none. */
  public List<Node> list(Node head) {
    List<Node> members = new ArrayList<>();
    Node rest = head;
    Set<Node> seen = new LinkedHashSet<>();
    while (!rest.equals(RDF.nil.asNode()) && seen.add(rest)) {
      Optional<Node> first = object(rest, RDF.first.asNode());
      if (first.isEmpty()) {
        return List.of(head);
      }
      members.add(first.get());
      rest = object(rest, RDF.rest.asNode()).orElse(RDF.nil.asNode());
    }
    return members;
  }

  /** What is wrong so far, by source and line. */
  public List<Fault> faults() {
    return faults.stream()
        .sorted(Comparator.comparing(Fault::source).thenComparing(Fault::line))
        .toList();
  }

  public void fault(Fault fault) {
    faults.add(fault);
  }

  /** Notes a fault in a statement about the subject; {@code value} is shown when given. */
  public void fault(
      Node subject, Node property, Optional<Node> value, String problem, String cure) {
    faults.add(told(subject, property, value, problem, cure));
  }

  /** Notes a fault in a subject as a whole. */
  public void fault(Node subject, String problem, String cure) {
    faults.add(told(subject, problem, cure));
  }

  /**
   * What is to be said of a statement about the subject, with its place; {@code value} is shown
   * when given.
   */
  public Fault told(
      Node subject, Node property, Optional<Node> value, String problem, String cure) {
    Origin origin = origin(subject, property, value);
    String shown = value.filter(v -> !v.isBlank()).map(v -> Nodes.shown(v) + " ").orElse("");
    return new Fault(
        origin.source(),
        origin.line(),
        Nodes.localName(owner(subject)),
        prefixed(property),
        shown + problem,
        cure);
  }

  /** What is to be said of a subject as a whole, with its place. */
  public Fault told(Node subject, String problem, String cure) {
    Origin origin = firstOrigin(subject);
    return new Fault(
        origin.source(), origin.line(), Nodes.localName(owner(subject)), "", problem, cure);
  }

  /** The name with the prefix that the texts give its namespace. */
  public String prefixed(Node property) {
    return prefixed(property, prefixes).orElseGet(() -> Nodes.localName(property));
  }

  /** The name as the text read last would write it. */
  public String written(Node word) {
    return prefixed(word, prefixes)
        .or(() -> prefixed(word, usualPrefixes))
        .orElseGet(() -> word.isURI() ? "<" + word.getURI() + ">" : Nodes.localName(word));
  }

  /** What of both the text that was read could contain. */
  public String inItsSyntax(String turtle, String jsonLd) {
    return usualPrefixes.isEmpty() ? turtle : jsonLd;
  }

  private static Optional<String> prefixed(Node word, Map<String, String> prefixes) {
    String local = Nodes.localName(word);
    return Optional.of(word)
        .filter(Node::isURI)
        .map(Node::getURI)
        .map(iri -> prefixes.get(iri.substring(0, iri.length() - local.length())))
        .map(prefix -> prefix + ":" + local);
  }

  private Origin origin(Node subject, Node property, Optional<Node> value) {
    return objects(subject, property).stream()
        .filter(object -> value.isEmpty() || value.get().equals(object))
        .map(object -> originOf(Triple.create(subject, property, object)))
        .findFirst()
        .orElseGet(() -> firstOrigin(subject));
  }

  /** The origin of a statement that is here; each came with one. */
  Origin originOf(Triple stated) {
    return Objects.requireNonNull(origins.get(stated));
  }

  private Origin firstOrigin(Node subject) {
    for (Map.Entry<Node, List<Node>> entry : bySubject.getOrDefault(subject, Map.of()).entrySet()) {
      return originOf(Triple.create(subject, entry.getKey(), entry.getValue().get(0)));
    }
    return new Origin("", 0);
  }

  /** The named node to which a blank one belongs. */
  private Node owner(Node node) {
    Node owner = node;
    Set<Node> seen = new LinkedHashSet<>();
    while (owner.isBlank() && seen.add(owner)) {
      Map<Node, List<Node>> referring = byObject.getOrDefault(owner, Map.of());
      if (referring.isEmpty()) {
        return owner;
      }
      owner = referring.values().iterator().next().get(0);
    }
    return owner;
  }
}
