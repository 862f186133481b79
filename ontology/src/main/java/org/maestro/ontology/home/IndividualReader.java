package org.maestro.ontology.home;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.apache.jena.graph.Node;
import org.apache.jena.vocabulary.RDF;
import org.apache.jena.vocabulary.RDFS;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.vocabulary.Literals;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * Reads what is said of a thing of a home: its classes with their ancestors, and its properties.
 */
final class IndividualReader {

  /** Said of a device for its member and agent, not as a property of the thing. */
  private static final Set<Node> STRUCTURE =
      Set.of(
          RDF.type.asNode(),
          RDFS.label.asNode(),
          RDFS.comment.asNode(),
          Maestro.term("offers"),
          Maestro.term("reports"),
          Maestro.term("setting"),
          Maestro.term("driver"),
          Maestro.term("container"),
          Maestro.term("pursues"),
          Maestro.term("benefit"),
          Maestro.term("chance"),
          Maestro.term("allowed"),
          Maestro.term("member"),
          Maestro.term("memberWhen"),
          Maestro.term("tracks"),
          Maestro.term("tells"),
          Maestro.term("supposes"),
          Maestro.term("foretells"),
          Maestro.term("noticesGuest"),
          Maestro.term("ways"),
          Maestro.term("wayOut"),
          Maestro.term("staysFor"),
          Maestro.term("staysAway"),
          Maestro.term("passesWithin"),
          Maestro.term("guestShare"),
          Maestro.term("sureFrom"),
          Maestro.term("foretellsFrom"));

  private final SourceGraph graph;
  private final Vocabulary vocabulary;
  private final Literals literals;

  IndividualReader(SourceGraph graph, Vocabulary vocabulary) {
    this.graph = graph;
    this.vocabulary = vocabulary;
    this.literals = new Literals(graph);
  }

  Individual read(Node node) {
    Set<String> classes = new TreeSet<>();
    for (Node type : graph.objects(node, RDF.type.asNode())) {
      if (isClassOf(node, type)) {
        classes.add(Literals.name(type));
        Optional.ofNullable(vocabulary.classes().get(Literals.name(type)))
            .ifPresent(declared -> classes.addAll(declared.ancestors()));
      }
    }
    Map<String, List<Term>> properties = new TreeMap<>();
    for (Node property : graph.predicates(node)) {
      if (!STRUCTURE.contains(property)) {
        properties
            .computeIfAbsent(Literals.name(property), name -> new ArrayList<>())
            .addAll(graph.objects(node, property).stream().map(Literals::term).toList());
      }
    }
    properties.replaceAll((name, values) -> sorted(values));
    takeNumbers(classes, properties);
    return new Individual(
        Literals.name(node), node.getURI(), literals.label(node), classes, properties);
  }

  /** Adds the numbers that are not stated by themselves, but in the text of another property. */
  private void takeNumbers(Set<String> classes, Map<String, List<Term>> properties) {
    for (PredicateDeclaration fluent : vocabulary.predicates().values()) {
      boolean isMeant =
          fluent.parameters().size() == 1
              && fluent.parameters().get(0).className().filter(classes::contains).isPresent();
      if (isMeant && !properties.containsKey(fluent.name())) {
        fluent.takenFrom().stream()
            .flatMapToDouble(
                from ->
                    properties.getOrDefault(from.property(), List.of()).stream()
                        .flatMapToDouble(value -> from.number(value).stream()))
            .findFirst()
            .ifPresent(number -> properties.put(fluent.name(), List.of(new Term.Number(number))));
      }
    }
  }

  /**
   * Whether the class counts: one of the vocabulary, or one that the text itself names and nobody
   * declares. What only an alignment adds, and what shares no more than a name, does not.
   */
  private boolean isClassOf(Node node, Node type) {
    if (!isNamed(type)) {
      return false;
    }
    return vocabulary
        .iri(Literals.name(type))
        .map(type.getURI()::equals)
        .orElseGet(() -> graph.isStated(node, RDF.type.asNode(), type));
  }

  private static boolean isNamed(Node type) {
    return type.isURI()
        && !type.getURI().startsWith("http://www.w3.org/2002/07/owl#")
        && !type.getURI().startsWith(RDFS.getURI());
  }

  private static List<Term> sorted(List<Term> values) {
    return values.stream().distinct().sorted(Comparator.comparing(SlPrinter::print)).toList();
  }
}
