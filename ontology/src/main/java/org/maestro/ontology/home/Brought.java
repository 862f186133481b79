package org.maestro.ontology.home;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.apache.jena.graph.Node;
import org.apache.jena.vocabulary.OWL;
import org.apache.jena.vocabulary.RDF;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.vocabulary.FeatureReader;
import org.maestro.ontology.vocabulary.Literals;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.ontology.vocabulary.VocabularyCheck;
import org.maestro.ontology.vocabulary.VocabularyReader;

/**
 * What a description may speak of beside its member: the features that only the member offers, the
 * words that its maker declares, and things of a class. Nothing of it may be a word that the
 * vocabulary has.
 */
final class Brought {

  private static final Node OFFERS = Maestro.term("offers");
  private static final List<Node> KINDS_OF_WORDS =
      List.of(OWL.Class.asNode(), Maestro.term("Predicate"), Maestro.term("Fluent"));

  private final SourceGraph graph;
  private final Vocabulary vocabulary;
  private final Node member;
  private final Set<Node> features = new LinkedHashSet<>();
  private final Set<Node> words = new LinkedHashSet<>();
  private final Map<String, Node> things = new LinkedHashMap<>();
  private final Set<Node> strangers = new LinkedHashSet<>();

  /**
   * @param source how faults and origins call the description
   */
  Brought(SourceGraph graph, Vocabulary vocabulary, Node member, String source) {
    this.graph = graph;
    this.vocabulary = vocabulary;
    this.member = member;
    for (Node offered : graph.objects(member, OFFERS)) {
      features.add(offered);
      graph.objects(offered, RDF.type.asNode()).stream()
          .filter(type -> FeatureReader.isFeature(graph, type))
          .forEach(features::add);
    }
    graph.subjectsOf(source).stream().filter(Node::isURI).forEach(this::sort);
  }

  private void sort(Node subject) {
    if (isKnown(subject)) {
      strangers.add(subject);
    } else if (isWord(graph, subject)) {
      words.add(subject);
    } else if (!subject.equals(member) && !features.contains(subject)) {
      if (isOfAClass(subject)) {
        things.put(Literals.name(subject), subject);
      } else if (!Alignment.isOnlyAligned(graph, subject)) {
        strangers.add(subject);
      }
    }
  }

  /** Whether a text declares a class, a predicate or a fluent with the node. */
  static boolean isWord(SourceGraph graph, Node subject) {
    return KINDS_OF_WORDS.stream()
        .anyMatch(kind -> graph.isStated(subject, RDF.type.asNode(), kind));
  }

  private boolean isKnown(Node subject) {
    return vocabulary.iri(Literals.name(subject)).filter(subject.getURI()::equals).isPresent();
  }

  /** One that the vocabulary has, or that the description declares. */
  private boolean isOfAClass(Node subject) {
    return graph.objects(subject, RDF.type.asNode()).stream()
        .filter(Node::isURI)
        .anyMatch(
            type ->
                graph.isStated(type, RDF.type.asNode(), OWL.Class.asNode())
                    || vocabulary.classes().containsKey(Literals.name(type)) && isKnown(type));
  }

  /** What it may not speak of becomes faults. */
  void refuseStrangers() {
    String name = Literals.name(member);
    for (Node stranger : strangers) {
      graph.fault(
          stranger,
          "is not for " + name + " to describe",
          "speak only of %s, of features, words and things that only it has, and give things a class"
              .formatted(name));
    }
  }

  /** The words that the description declares. */
  Vocabulary words() {
    Vocabulary read = new VocabularyReader(graph, vocabulary).read(words);
    return new Vocabulary(read.classes(), read.predicates(), Map.of());
  }

  /** The things that it brings; what has a say in the home's map or rights is refused. */
  Map<String, Individual> things(IndividualReader reader) {
    Map<String, Individual> read = new TreeMap<>();
    things.forEach(
        (name, node) -> {
          Individual thing = reader.read(node);
          read.put(name, thing);
          Extension.objection(thing.classes())
              .ifPresent(objection -> graph.fault(node, objection.problem(), objection.cure()));
        });
    return read;
  }

  /** Words and things have to be such as a home could have. */
  void check(VocabularyCheck ofWords, HomeCheck ofThings) {
    words.forEach(ofWords::check);
    things.values().forEach(thing -> ofThings.checkThing(thing, false));
  }
}
