package org.maestro.ontology.home;

import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.apache.jena.graph.Node;
import org.apache.jena.graph.NodeFactory;
import org.apache.jena.vocabulary.OWL;
import org.apache.jena.vocabulary.RDF;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.vocabulary.Literals;

/**
 * The shipped words of households. A home that speaks of one of them has them all, as far as it
 * leaves them room: where it has a word, a thing or a script of the same name, its own counts, and
 * what is built on the household's word is left away with it. To a home that speaks of none they
 * are not there, so that it means what it meant before they were shipped, and devices may bring
 * such words of their own. Immutable, safe for threads.
 */
final class HouseholdWords {

  /** Which vocabulary a home speaks, beside the domain's. */
  private static final Node SPEAKS = Maestro.term("speaks");

  private static final Node HOUSEHOLD = NodeFactory.createURI("https://w3id.org/maestro/household");

  private static final Set<Node> WORDS =
      Stream.concat(
              Stream.of(OWL.Class.asNode()),
              Stream.of("Predicate", "Fluent", "Action", "Task", "Script").map(Maestro::term))
          .collect(Collectors.toUnmodifiableSet());

  /** Properties whose texts are written in words of the vocabulary. */
  private static final Set<Node> FORMAL =
      Stream.concat(
              Stream.of(RDF.first.asNode()),
              Stream.of(
                      "derivedWhen",
                      "observedWhen",
                      "likelyWhen",
                      "fact",
                      "precondition",
                      "effect",
                      "cost",
                      "seconds",
                      "holdsWhen",
                      "broughtAboutBy",
                      "means",
                      "arguments",
                      "body",
                      "tells",
                      "supposes",
                      "foretells",
                      "noticesGuest",
                      "ways")
                  .map(Maestro::term))
          .collect(Collectors.toUnmodifiableSet());

  private static final Pattern NAME = Pattern.compile("(?<![\\w?:-])[A-Za-z][\\w-]*");

  private final SourceGraph words;
  private final Map<Node, Set<String>> usedBy = new HashMap<>();

  /**
   * @param words the shipped file, whole
   */
  HouseholdWords(SourceGraph words) {
    this.words = words;
    named(words).forEach(word -> usedBy.put(word, used(word)));
  }

  /**
   * Adds them to a graph.
   *
   * @param source the text of the graph that comes first
   */
  void addTo(SourceGraph graph, String source) {
    Set<Node> left = new LinkedHashSet<>(usedBy.keySet());
    Set<String> gone = takenBy(graph, source);
    if (!isSpoken(graph, source, gone)) {
      ownWords().map(Literals::name).forEach(gone::add);
      left.remove(HOUSEHOLD);
    }
    left.removeIf(word -> isWord(words, word) && gone.contains(Literals.name(word)));
    while (left.removeIf(
        word -> usedBy.getOrDefault(word, Set.of()).stream().anyMatch(gone::contains))) {
      ownWords()
          .filter(word -> !left.contains(word))
          .forEach(word -> gone.add(Literals.name(word)));
    }
    Set<Node> wanted = new HashSet<>(left);
    left.forEach(word -> parts(word, wanted));
    graph.copy(words, triple -> wanted.contains(triple.getSubject()));
  }

  /** Says beside a home's own words that they go with these, if the home has them. */
  static void note(SourceGraph ownWords, SourceGraph graph, Node home) {
    if (graph.isA(HOUSEHOLD, OWL.Ontology.asNode())) {
      ownWords.state(home, SPEAKS, HOUSEHOLD);
    }
  }

  /** Whether a text speaks of one of the words, or says that it does. */
  private boolean isSpoken(SourceGraph graph, String source, Set<String> taken) {
    Set<Node> shipped =
        ownWords().filter(word -> !taken.contains(Literals.name(word))).collect(Collectors.toSet());
    shipped.add(HOUSEHOLD);
    return graph.subjectsOf(source).stream()
        .anyMatch(
            subject ->
                graph.predicates(subject).stream()
                    .anyMatch(
                        property ->
                            shipped.contains(property)
                                || graph.objects(subject, property).stream()
                                    .anyMatch(shipped::contains)));
  }

  private Stream<Node> ownWords() {
    return usedBy.keySet().stream().filter(word -> isWord(words, word));
  }

  /** Names of words that the text has otherwise, or says anew. */
  private Set<String> takenBy(SourceGraph graph, String source) {
    Map<String, Node> own = new HashMap<>();
    ownWords().forEach(word -> own.put(Literals.name(word), word));
    return graph.subjectsOf(source).stream()
        .filter(Node::isURI)
        .filter(
            subject -> {
              Node word = own.get(Literals.name(subject));
              return word != null && (!word.equals(subject) || isWord(graph, subject));
            })
        .map(Literals::name)
        .collect(Collectors.toCollection(HashSet::new));
  }

  private static List<Node> named(SourceGraph graph) {
    return graph.subjects().stream().filter(Node::isURI).toList();
  }

  private static boolean isWord(SourceGraph graph, Node node) {
    return graph.objects(node, RDF.type.asNode()).stream().anyMatch(WORDS::contains);
  }

  /** The blank nodes of which a node consists. */
  private void parts(Node node, Set<Node> into) {
    for (Node property : words.predicates(node)) {
      for (Node object : words.objects(node, property)) {
        if (object.isBlank() && into.add(object)) {
          parts(object, into);
        }
      }
    }
  }

  /** The names that are used to say what a word is. */
  private Set<String> used(Node word) {
    Set<Node> said = new HashSet<>(Set.of(word));
    parts(word, said);
    Set<String> names = new HashSet<>();
    for (Node part : said) {
      for (Node property : words.predicates(part)) {
        names.add(Literals.name(property));
        words
            .objects(part, property)
            .forEach(
                object -> {
                  if (object.isURI()) {
                    names.add(Literals.name(object));
                  } else if (object.isLiteral() && FORMAL.contains(property)) {
                    Matcher name = NAME.matcher(Literals.name(object));
                    while (name.find()) {
                      names.add(name.group());
                    }
                  }
                });
      }
    }
    names.remove(Literals.name(word));
    return names;
  }
}
