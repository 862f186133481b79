package org.maestro.ontology.home;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.apache.jena.graph.Node;
import org.maestro.ontology.validation.Fault;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.validation.SourceReader;
import org.maestro.ontology.vocabulary.Literals;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.ontology.vocabulary.VocabularyCheck;

/**
 * Reads the description that a member sends of itself. A feature that the vocabulary knows needs
 * its type's name and what differs; any other is described whole. Words of other vocabularies are
 * understood as far as the alignments tell (Three-layered architecture, 1; M7). Words and things
 * that the vocabulary has not are brought by the description that declares them. A description that
 * offers nothing has what its classes offer. Never uses the network. Safe for threads.
 */
public final class DescriptionReader {

  private static final String BASE = "https://w3id.org/maestro/member/";

  /** What no device can be by its own word. */
  private static final List<String> NO_DEVICE = List.of("Permission", "GroupAgent", "Home");

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
    Alignment alignment = new Alignment(graph, background, vocabulary);
    return understood(alignment.applied(graph), member, alignment);
  }

  private Device understood(SourceGraph graph, String member, Alignment alignment) {
    Node node = memberNode(graph, member);
    background.explain(graph, node, alignment);
    Brought brought = new Brought(graph, vocabulary, node, member);
    brought.refuseStrangers();
    refuseFaults(graph);
    Vocabulary own = brought.words();
    Vocabulary all = vocabulary.with(own);
    graph.copy(metaVocabulary, triple -> true);
    HomeLoader.shapes().check(graph);
    IndividualReader individuals = new IndividualReader(graph, all);
    Individual individual = individuals.read(node);
    if (!individual.classes().contains("Device")) {
      graph.fault(
          node,
          "is no maestro:Device",
          "add the type %s, or a class that the vocabulary has under it"
              .formatted(graph.written(Maestro.term("Device"))));
    }
    if (!Collections.disjoint(individual.classes(), NO_DEVICE)) {
      graph.fault(
          node,
          "is said to be " + String.join(", ", individual.classes()),
          "leave away " + String.join(", ", NO_DEVICE) + "; these are the home's to say");
    }
    VocabularyCheck words = new VocabularyCheck(graph, all, name -> true);
    Device device = new DeviceReader(graph, all, words).read(node, individual);
    HomeCheck check = new HomeCheck(graph, all);
    check.checkDescription(node);
    brought.check(words, check);
    Extension extension =
        new Extension(own, brought.things(individuals), alignment.synonyms(), alignment.borrowed());
    refuseFaults(graph);
    return device.bringing(extension);
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

  private static void refuseFaults(SourceGraph graph) {
    if (!graph.faults().isEmpty()) {
      throw new HomeFaultException(graph.faults());
    }
  }
}
