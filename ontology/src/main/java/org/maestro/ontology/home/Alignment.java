package org.maestro.ontology.home;

import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.apache.jena.graph.Node;
import org.apache.jena.graph.NodeFactory;
import org.apache.jena.graph.Triple;
import org.apache.jena.vocabulary.OWL;
import org.apache.jena.vocabulary.RDF;
import org.apache.jena.vocabulary.RDFS;
import org.apache.jena.vocabulary.XSD;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.vocabulary.Literals;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Synonyms;

/**
 * Those of a description's words that mean what the home, or another maker, calls otherwise, as
 * {@code owl:equivalentClass} and {@code owl:equivalentProperty} tell in it and in the home. One
 * word stands for all that mean the same, so that every reader takes the same one without knowing
 * other descriptions: the home's; else the first, by its IRI, of those of which the home tells that
 * they mean the same; else that of the other maker, who may know nothing of it.
 */
final class Alignment {

  private static final Set<Node> EQUIVALENT =
      Set.of(OWL.equivalentClass.asNode(), OWL.equivalentProperty.asNode());
  private static final Set<Node> ABOUT_WORDS =
      Set.of(
          OWL.equivalentClass.asNode(),
          OWL.equivalentProperty.asNode(),
          RDFS.subClassOf.asNode(),
          RDFS.subPropertyOf.asNode());
  private static final Node ARGUMENTS = Maestro.term("arguments");
  private static final Node SENTENCE = Maestro.term("sentence");

  private final SourceGraph description;
  private final Background background;
  private final Vocabulary vocabulary;
  private final Set<Node> bridged = new HashSet<>();
  private final Map<Node, Node> common = new LinkedHashMap<>();
  private final Synonyms synonyms;

  /**
   * @param background what the home states of words of others
   * @param vocabulary the home's words
   */
  Alignment(SourceGraph description, Background background, Vocabulary vocabulary) {
    this.description = description;
    this.background = background;
    this.vocabulary = vocabulary;
    Map<Node, Set<Node>> same = new LinkedHashMap<>();
    joinAll(background.ofHome(), same);
    bridged.addAll(same.keySet());
    joinAll(description, same);
    same.forEach(
        (word, all) -> {
          Node one = commonOf(all);
          if (!one.equals(word) && !isOfHome(word)) {
            common.put(word, one);
          }
        });
    this.synonyms = synonyms(common);
  }

  private static void joinAll(SourceGraph graph, Map<Node, Set<Node>> same) {
    for (Node equivalent : EQUIVALENT) {
      for (Node word : graph.subjectsWith(equivalent)) {
        graph.objects(word, equivalent).stream()
            .filter(other -> word.isURI() && other.isURI())
            .forEach(other -> join(word, other, same));
      }
    }
  }

  private static void join(Node one, Node other, Map<Node, Set<Node>> same) {
    Set<Node> all = new LinkedHashSet<>(same.getOrDefault(one, Set.of(one)));
    all.addAll(same.getOrDefault(other, Set.of(other)));
    all.forEach(word -> same.put(word, all));
  }

  private Node commonOf(Set<Node> words) {
    return words.stream()
        .min(
            Comparator.comparing((Node word) -> !isOfHome(word))
                .thenComparing(word -> !bridged.contains(word))
                .thenComparing(word -> !isAnothers(word))
                .thenComparing(word -> word.getURI()))
        .orElseThrow();
  }

  /** Whether another maker may declare the word, which can be used as it is called then. */
  private boolean isAnothers(Node word) {
    return !Brought.isWord(description, word)
        && !background.explains(word)
        && vocabulary.iri(Literals.name(word)).isEmpty();
  }

  /** Local names of words that stand for the description's, and are no words of the home. */
  Set<String> borrowed() {
    return common.values().stream()
        .filter(word -> !isOfHome(word))
        .map(Literals::name)
        .collect(Collectors.toSet());
  }

  private boolean isOfHome(Node word) {
    return vocabulary.iri(Literals.name(word)).filter(word.getURI()::equals).isPresent();
  }

  /** Whether the graph says of the node only how it is to be understood, and not what it is. */
  static boolean isOnlyAligned(SourceGraph graph, Node word) {
    return ABOUT_WORDS.containsAll(graph.predicates(word));
  }

  /** What a text of the description means by its words, where that differs. */
  Synonyms synonyms() {
    return synonyms;
  }

  private static Synonyms synonyms(Map<Node, Node> common) {
    Map<String, String> names = new TreeMap<>();
    common.forEach(
        (own, word) -> {
          if (!Literals.name(own).equals(Literals.name(word))) {
            names.put(Literals.name(own), Literals.name(word));
          }
        });
    return new Synonyms(names);
  }

  /** The description in common words; how others declare them stands above how it does. */
  SourceGraph applied(SourceGraph description) {
    if (common.isEmpty()) {
      return description;
    }
    SourceGraph applied = new SourceGraph();
    applied.copyPrefixes(description);
    applied.copyMapped(description, this::meaning);
    common.forEach((own, word) -> checkArguments(own, word, description, applied));
    return applied;
  }

  /** A statement in common words; empty when these make it say nothing new. */
  Optional<Triple> meaning(Triple triple) {
    Node subject = triple.getSubject();
    Node predicate = triple.getPredicate();
    Node object = triple.getObject();
    boolean isDeclaredElsewhere = common.containsKey(subject) && isOfHome(word(subject));
    boolean saysThatItIsItself = word(subject).equals(word(object));
    if (isDeclaredElsewhere || saysThatItIsItself) {
      return Optional.empty();
    }
    return Optional.of(
        Triple.create(
            word(subject), word(predicate), isFormula(triple) ? text(object) : word(object)));
  }

  /** Formulas stand in properties of the meta-vocabulary, and in lists of arguments. */
  private static boolean isFormula(Triple triple) {
    Node predicate = triple.getPredicate();
    return triple.getObject().isLiteral()
        && XSD.xstring.getURI().equals(triple.getObject().getLiteralDatatypeURI())
        && !predicate.equals(SENTENCE)
        && (predicate.getURI().startsWith(Maestro.NAMESPACE)
            || predicate.equals(RDF.first.asNode()));
  }

  private Node text(Node formula) {
    return NodeFactory.createLiteralString(synonyms.translated(formula.getLiteralLexicalForm()));
  }

  private Node word(Node node) {
    return common.getOrDefault(node, node);
  }

  private void checkArguments(Node own, Node word, SourceGraph description, SourceGraph applied) {
    Optional<Node> arguments = description.object(own, ARGUMENTS);
    vocabulary
        .predicate(Literals.name(word))
        .filter(declared -> declared.iri().equals(word.getURI()))
        .filter(
            declared ->
                arguments
                    .filter(list -> description.list(list).size() != declared.parameters().size())
                    .isPresent())
        .ifPresent(
            declared ->
                applied.fault(
                    word,
                    "has %d arguments, and %s, which is said to be the same, has %d"
                        .formatted(
                            declared.parameters().size(),
                            Literals.name(own),
                            description.list(arguments.orElseThrow()).size()),
                    "give both the same arguments in the same order, or do not say that"));
  }
}
