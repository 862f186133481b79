package org.maestro.ontology.home;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import org.maestro.ontology.validation.Fault;
import org.maestro.ontology.validation.Inference;
import org.maestro.ontology.validation.ShapeCheck;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.validation.SourceReader;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.ontology.vocabulary.VocabularyCheck;
import org.maestro.ontology.vocabulary.VocabularyReader;

/**
 * Loads homes: reads the file together with the vocabulary, adds what follows from both, and
 * refuses the whole when anything in it is wrong. Follows no {@code owl:imports} and never uses the
 * network. Stateless, safe for threads.
 */
public final class HomeLoader {

  private static final String META_RESOURCE = "maestro.ttl";
  private static final String DOMAIN_RESOURCE = "domain.ttl";
  private static final List<String> HOUSEHOLD_RESOURCES =
      List.of("household.ttl", "words-en.ttl", "words-de.ttl");
  private static final String SHAPES_RESOURCE = "shapes.ttl";
  private static final String USUAL_RESOURCE = "usual.ttl";
  private static final List<String> ALIGNMENTS =
      List.of(
          "alignment/bot.ttl",
          "alignment/css.ttl",
          "alignment/saref.ttl",
          "alignment/sosa.ttl",
          "alignment/td.ttl");
  private static final String VOCABULARY_BASE = "https://w3id.org/maestro";
  static final String OWN_WORDS = "the words of the home";
  private static final String HOMES_BASE = "https://w3id.org/maestro/home/";

  private final Optional<List<String>> domainTexts;

  /** With the shipped domain vocabulary. */
  public HomeLoader() {
    this(Optional.empty());
  }

  private HomeLoader(Optional<List<String>> domainTexts) {
    this.domainTexts = domainTexts;
  }

  /**
   * With other domain vocabularies in place of the shipped one; the meta-vocabulary stays.
   *
   * @param turtleTexts any number of Turtle documents; faults call them {@code vocabulary 1} and so
   *     on
   */
  public static HomeLoader withVocabulary(List<String> turtleTexts) {
    return new HomeLoader(Optional.of(List.copyOf(turtleTexts)));
  }

  /** The shipped domain vocabulary as Turtle. */
  public static String shippedVocabulary() {
    return resource(DOMAIN_RESOURCE);
  }

  /**
   * Loads a home file.
   *
   * @throws HomeFaultException with every fault that was found, also when the file cannot be read
   */
  public Home load(Path file) {
    return read(text(file), name(file), folder(file), new SourceGraph());
  }

  private static String name(Path file) {
    return String.valueOf(file.getFileName());
  }

  private static Optional<Path> folder(Path file) {
    return Optional.ofNullable(file.toAbsolutePath().getParent());
  }

  private static String text(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      throw new HomeFaultException(
          List.of(
              new Fault(
                  file.toString(),
                  0,
                  "the file",
                  "",
                  "cannot be read (" + e.getClass().getSimpleName() + ")",
                  "give the path of a Turtle file in UTF-8")));
    }
  }

  /**
   * Loads a home from its text.
   *
   * @param baseName how faults call the text, such as {@code bob.ttl}
   * @throws HomeFaultException with every fault that was found
   */
  public Home load(String text, String baseName) {
    return read(text, baseName, Optional.empty(), new SourceGraph());
  }

  /**
   * Loads a home file, and looks at what in it is no fault, but hardly meant so.
   *
   * @throws HomeFaultException with every fault that was found, also when the file cannot be read
   */
  public CheckedHome check(Path file) {
    return check(text(file), name(file), folder(file));
  }

  /**
   * Loads a home from its text, and looks at what its devices need to be run, and at what is no
   * fault, but hardly meant so.
   *
   * @param baseName how faults and warnings call the text, such as {@code bob.ttl}
   * @throws HomeFaultException with every fault that was found
   */
  public CheckedHome check(String text, String baseName) {
    return check(text, baseName, Optional.empty());
  }

  private CheckedHome check(String text, String baseName, Optional<Path> folder) {
    SourceGraph graph = new SourceGraph();
    Home home = read(text, baseName, folder, graph);
    CheckedHome checked = new CheckedHome(home, new HomeDoubts(graph, home).found());
    refuseFaults(graph);
    return checked;
  }

  /**
   * @param folder in which the home's file is, and what it brings; empty: it was not read from one
   */
  private Home read(String text, String baseName, Optional<Path> folder, SourceGraph graph) {
    readVocabulary(graph);
    String base = HOMES_BASE + baseName.replaceFirst("\\.ttl$", "").replaceAll("[^\\w.-]", "-");
    new SourceReader(graph, baseName, base).readTurtle(text);
    refuseFaults(graph);
    BroughtLanguages brought = new BroughtLanguages(graph, folder);
    brought.addWords(base);
    Map<String, String> grammars = brought.grammars();
    refuseFaults(graph);
    addHousehold(graph, baseName);
    new Inference(graph).run();
    shapes().check(graph);
    Vocabulary vocabulary = new VocabularyReader(graph).read();
    Home home = new HomeReader(graph, vocabulary, baseName).read();
    refuseFaults(graph);
    return grammars.isEmpty()
        ? home
        : home.knownAs(home.individuals(), home.wording().spokenBy(grammars));
  }

  /** The vocabulary without a home. */
  public Vocabulary vocabulary() {
    SourceGraph graph = new SourceGraph();
    readVocabulary(graph);
    addHousehold(graph, OWN_WORDS);
    return vocabulary(graph, name -> false);
  }

  /**
   * The vocabulary with what a home adds to it, but without what is in that home.
   *
   * @param words as {@link Home#words} has them; they may name things of the home
   * @throws HomeFaultException with every fault that was found
   */
  public Vocabulary vocabularyWith(String words) {
    SourceGraph graph = new SourceGraph();
    readVocabulary(graph);
    new SourceReader(graph, OWN_WORDS, HOMES_BASE).readTurtle(words);
    addHousehold(graph, OWN_WORDS);
    return vocabulary(graph, name -> true);
  }

  private static Vocabulary vocabulary(SourceGraph graph, Predicate<String> isThing) {
    refuseFaults(graph);
    new Inference(graph).run();
    shapes().check(graph);
    Vocabulary vocabulary = new VocabularyReader(graph).read();
    new VocabularyCheck(graph, vocabulary, isThing).check();
    refuseFaults(graph);
    return vocabulary;
  }

  private void readVocabulary(SourceGraph graph) {
    readMetaVocabulary(graph);
    if (domainTexts.isEmpty()) {
      new SourceReader(graph, DOMAIN_RESOURCE, VOCABULARY_BASE + "/domain")
          .readTurtle(resource(DOMAIN_RESOURCE));
      ALIGNMENTS.forEach(
          name -> new SourceReader(graph, name, VOCABULARY_BASE).readTurtle(resource(name)));
      return;
    }
    int number = 1;
    for (String text : domainTexts.get()) {
      new SourceReader(graph, "vocabulary " + number++, VOCABULARY_BASE + "/domain")
          .readTurtle(text);
    }
  }

  /** Words of households come with the shipped domain only, behind the home's own. */
  private void addHousehold(SourceGraph graph, String source) {
    if (domainTexts.isEmpty()) {
      ShippedHousehold.WORDS.addTo(graph, source);
    }
  }

  /** Read when first needed; immutable. */
  private static final class ShippedHousehold {
    private static final HouseholdWords WORDS = read();

    private static HouseholdWords read() {
      SourceGraph graph = new SourceGraph();
      HOUSEHOLD_RESOURCES.forEach(
          name ->
              new SourceReader(graph, name, VOCABULARY_BASE + "/domain")
                  .readTurtle(resource(name)));
      return new HouseholdWords(graph);
    }
  }

  /** The shipped vocabulary, its alignments and a home's words, with what follows from them. */
  static SourceGraph statementsWith(String ownWords) {
    SourceGraph graph = new SourceGraph();
    HomeLoader loader = new HomeLoader();
    loader.readVocabulary(graph);
    new SourceReader(graph, OWN_WORDS, HOMES_BASE).readTurtle(ownWords);
    loader.addHousehold(graph, OWN_WORDS);
    new Inference(graph).run();
    return graph;
  }

  static void readMetaVocabulary(SourceGraph graph) {
    new SourceReader(graph, META_RESOURCE, VOCABULARY_BASE).readTurtle(resource(META_RESOURCE));
  }

  static ShapeCheck shapes() {
    return ShippedShapes.CHECK;
  }

  /** Read when first needed; immutable. */
  private static final class ShippedShapes {
    private static final ShapeCheck CHECK = new ShapeCheck(resource(SHAPES_RESOURCE));
  }

  /** What homes usually say; what they do not is a warning, or keeps them from being run. */
  static ShapeCheck usualShapes() {
    return UsualShapes.CHECK;
  }

  /** Read when first needed; immutable. */
  private static final class UsualShapes {
    private static final ShapeCheck CHECK = new ShapeCheck(resource(USUAL_RESOURCE));
  }

  private static void refuseFaults(SourceGraph graph) {
    if (!graph.faults().isEmpty()) {
      throw new HomeFaultException(graph.faults());
    }
  }

  private static String resource(String name) {
    try (InputStream stream =
        HomeLoader.class.getResourceAsStream("/org/maestro/ontology/" + name)) {
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException("The vocabulary " + name + " cannot be read from the jar.", e);
    }
  }
}
