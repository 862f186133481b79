package org.maestro.ontology.home;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.apache.jena.graph.Node;
import org.apache.jena.vocabulary.RDF;
import org.maestro.ontology.validation.Fault;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.validation.SourceReader;
import org.maestro.ontology.vocabulary.FeatureReader;
import org.maestro.ontology.vocabulary.Literals;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.ontology.vocabulary.VocabularyCheck;

/**
 * Reads the description that a member sends of itself. A feature that the vocabulary knows needs
 * its type's name and what differs; any other is described whole. Words of other vocabularies are
 * understood as far as the alignments tell (Three-layered architecture, 1; M7). A description that
 * offers nothing has what its classes offer. Never uses the network. Safe for threads.
 */
public final class DescriptionReader {

  private static final String BASE = "https://w3id.org/maestro/member/";

  private final Vocabulary vocabulary;
  private final Background background;
  private final SourceGraph metaVocabulary = new SourceGraph();
  private final ReadDevices known = new ReadDevices();

  /** For descriptions of a home that adds nothing to the vocabulary that is shipped. */
  public DescriptionReader(Vocabulary vocabulary) {
    this(vocabulary, "");
  }

  /**
   * @param ownWords what the home adds to the vocabulary that is shipped, as {@link Home#words} has
   *     it; the vocabulary has it already
   */
  public DescriptionReader(Vocabulary vocabulary, String ownWords) {
    this.vocabulary = vocabulary;
    this.background = new Background(ownWords);
    HomeLoader.readMetaVocabulary(metaVocabulary);
  }

  /** For descriptions of devices of the home. */
  public static DescriptionReader of(Home home) {
    return new DescriptionReader(home.vocabulary(), home.words());
  }

  /**
   * Reads and validates a description.
   *
   * @param text as JSON-LD, or as Turtle, as people write it
   * @param member the id of the member that sent it; it may speak of nothing else
   * @throws HomeFaultException with every fault that was found
   */
  public Device read(String text, String member) {
    return known
        .find(member, text)
        .orElseGet(
            () -> {
              Device device = readAnew(text, member);
              known.keep(member, text, device);
              return device;
            });
  }

  private Device readAnew(String text, String member) {
    SourceGraph graph = new SourceGraph();
    SourceReader source = new SourceReader(graph, member, BASE + "#");
    if (isJson(text)) {
      source.readJsonLd(text);
    } else {
      source.readTurtle(text);
    }
    refuseFaults(graph);
    Node node = memberNode(graph, member);
    background.explain(graph, node);
    refuseStrangers(graph, node, member);
    refuseFaults(graph);
    graph.copy(metaVocabulary, triple -> true);
    HomeLoader.shapes().check(graph);
    Individual individual = new IndividualReader(graph, vocabulary).read(node);
    if (!individual.classes().contains("Device")) {
      graph.fault(
          node,
          "is no maestro:Device",
          "add the type "
              + Maestro.NAMESPACE
              + "Device, or a class that the vocabulary has under it");
    }
    VocabularyCheck words = new VocabularyCheck(graph, vocabulary, name -> true);
    Device device = new DeviceReader(graph, vocabulary, words).read(node, individual);
    new HomeCheck(graph, vocabulary).checkDescription(node);
    refuseFaults(graph);
    return device;
  }

  static boolean isJson(String text) {
    String begin = text.stripLeading();
    return begin.startsWith("{") || begin.startsWith("[{") || begin.isEmpty();
  }

  private static Node memberNode(SourceGraph graph, String member) {
    Optional<Node> node =
        graph.subjects().stream()
            .filter(subject -> subject.isURI() && Literals.name(subject).equals(member))
            .findFirst();
    return node.orElseThrow(
        () ->
            new HomeFaultException(
                List.of(
                    new Fault(
                        member,
                        0,
                        "the description",
                        "",
                        "does not speak of " + member,
                        "give it an id that ends in #" + member))));
  }

  /**
   * A description speaks of its member, of the features that only it offers, and of nothing else.
   */
  private void refuseStrangers(SourceGraph graph, Node member, String source) {
    Set<Node> own = new LinkedHashSet<>(Set.of(member));
    for (Node offered : graph.objects(member, Maestro.term("offers"))) {
      own.add(offered);
      graph.objects(offered, RDF.type.asNode()).stream()
          .filter(type -> FeatureReader.isFeature(graph, type))
          .forEach(own::add);
    }
    for (Node subject : graph.subjectsOf(source)) {
      boolean redefines =
          subject.isURI() && vocabulary.features().containsKey(Literals.name(subject));
      if (subject.isURI() && (redefines || !own.contains(subject))) {
        graph.fault(
            subject,
            "is not for " + Literals.name(member) + " to describe",
            "speak only of " + Literals.name(member) + " and of features that only it has");
      }
    }
  }

  private static void refuseFaults(SourceGraph graph) {
    if (!graph.faults().isEmpty()) {
      throw new HomeFaultException(graph.faults());
    }
  }
}
