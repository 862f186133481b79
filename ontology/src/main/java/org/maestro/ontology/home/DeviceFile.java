package org.maestro.ontology.home;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Predicate;
import org.apache.jena.graph.Node;
import org.apache.jena.vocabulary.RDF;
import org.maestro.ontology.validation.Fault;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.validation.SourceReader;
import org.maestro.ontology.vocabulary.Literals;

/**
 * A file that describes one device or several, as a home file does, without the home: what a
 * generic agent is configured with (Three-layered architecture, 3.3.2; M68, M69). Turtle, or
 * JSON-LD as members send it. Safe for threads.
 */
public final class DeviceFile {
  private static final String BASE = "https://w3id.org/maestro/member/";
  private static final Node OFFERS = Maestro.term("offers");

  private final BiFunction<String, String, Device> reader;
  private final Predicate<String> isOfThings;

  /** A device's id, what the file says of it, and what that means. */
  public record Described(String id, String text, Device device) {}

  /**
   * @param reader of single descriptions (first argument) of devices (second)
   */
  public DeviceFile(BiFunction<String, String, Device> reader) {
    this(reader, name -> false);
  }

  /**
   * @param isOfThings which classes, by local name, are of things that devices bring
   */
  DeviceFile(BiFunction<String, String, Device> reader, Predicate<String> isOfThings) {
    this.reader = reader;
    this.isOfThings = isOfThings;
  }

  /**
   * Reads a file.
   *
   * @return at least one device, in the order of the file
   * @throws HomeFaultException with every fault that was found, also when the file cannot be read
   */
  public List<Described> read(Path file) {
    String name = String.valueOf(file.getFileName());
    try {
      return read(Files.readString(file), name);
    } catch (IOException e) {
      throw fault(
          file.toString(),
          "the file",
          "cannot be read (" + e.getClass().getSimpleName() + ")",
          "give the path of a Turtle file in UTF-8");
    }
  }

  /**
   * Reads a text.
   *
   * @param name how faults call it, such as {@code lamp-9.ttl}
   */
  public List<Described> read(String text, String name) {
    SourceGraph graph = new SourceGraph();
    SourceReader source = new SourceReader(graph, name, BASE + "#");
    if (DescriptionReader.isJson(text)) {
      source.readJsonLd(text);
    } else {
      source.readTurtle(text);
    }
    if (!graph.faults().isEmpty()) {
      throw new HomeFaultException(graph.faults());
    }
    Set<Node> devices = devices(graph);
    if (devices.isEmpty()) {
      throw fault(
          name,
          "the file",
          "describes no device",
          DescriptionReader.isJson(text)
              ? "give one an id and a type, such as \"type\": \"domain:Lamp\", and state what it offers"
              : "give one a type, such as <#lamp-9> a :Lamp, and state what it offers");
    }
    List<Described> described = new ArrayList<>();
    for (Node device : devices) {
      String id = Literals.name(device);
      String its = devices.size() == 1 ? text : part(graph, device).turtle();
      described.add(new Described(id, its, read(its, id, name, its.equals(text))));
    }
    return List.copyOf(described);
  }

  /**
   * Faults are told by the file that they are in, what is said of single properties first.
   *
   * @param isWhole the text is the file's, so that its lines are
   */
  private Device read(String text, String id, String file, boolean isWhole) {
    try {
      return reader.apply(text, id);
    } catch (HomeFaultException e) {
      throw new HomeFaultException(
          e.faults().stream()
              .map(
                  f ->
                      new Fault(
                          file,
                          isWhole ? f.line() : 0,
                          f.subject(),
                          f.property(),
                          f.problem(),
                          f.cure()))
              .sorted(Comparator.comparing(f -> f.property().isEmpty()))
              .toList());
    }
  }

  /**
   * Named subjects with a type, but for the kinds of features that one of them describes, for words
   * that the file declares, and for things of classes that only it has, where there is a device
   * beside them.
   */
  private Set<Node> devices(SourceGraph graph) {
    Set<Node> offered = new LinkedHashSet<>();
    for (Node subject : graph.subjects()) {
      for (Node feature : graph.objects(subject, OFFERS)) {
        offered.add(feature);
        offered.addAll(graph.objects(feature, RDF.type.asNode()));
      }
    }
    Set<Node> devices = new LinkedHashSet<>();
    Set<Node> things = new LinkedHashSet<>();
    for (Node subject : graph.subjects()) {
      List<Node> types = graph.objects(subject, RDF.type.asNode());
      if (subject.isURI()
          && !types.isEmpty()
          && !offered.contains(subject)
          && !Brought.isWord(graph, subject)) {
        boolean isOfOwnClasses =
            types.stream()
                .allMatch(
                    type -> Brought.isWord(graph, type) || isOfThings.test(Literals.name(type)));
        boolean offers = !graph.objects(subject, OFFERS).isEmpty();
        (isOfOwnClasses && !offers ? things : devices).add(subject);
      }
    }
    return devices.isEmpty() ? things : devices;
  }

  /** What is said of one device, of the features that it describes, and of the file's words. */
  private static SourceGraph part(SourceGraph whole, Node device) {
    SourceGraph part = new SourceGraph();
    part.copyPrefixes(whole);
    whole.subjects().stream()
        .filter(subject -> Brought.isWord(whole, subject))
        .forEach(word -> part.copyAbout(word, whole));
    part.copyAbout(device, whole);
    for (Node feature : whole.objects(device, OFFERS)) {
      part.copyAbout(feature, whole);
      whole.objects(feature, RDF.type.asNode()).forEach(type -> part.copyAbout(type, whole));
    }
    return part;
  }

  private static HomeFaultException fault(
      String source, String subject, String problem, String cure) {
    return new HomeFaultException(List.of(new Fault(source, 0, subject, "", problem, cure)));
  }
}
