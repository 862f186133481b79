package org.maestro.ontology.home;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.BiConsumer;
import java.util.regex.Pattern;
import org.apache.jena.graph.Node;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.validation.SourceReader;

/**
 * The files by which a home brings languages of its own (ADE, 6; A95): grammars, and words in
 * Turtle. They stand in the folder of its file, or below. What cannot be read becomes a fault of
 * the home.
 */
final class BroughtLanguages {
  private static final Node GRAMMAR = Maestro.term("grammarFile");
  private static final Node WORDS = Maestro.term("wordsFile");
  private static final String ENDING = ".grammar";
  private static final Pattern A_GRAMMAR =
      Pattern.compile("(\\w[\\w.-]*/)*[A-Za-z][A-Za-z-]*\\.grammar");
  private static final Pattern SOME_WORDS = Pattern.compile("(\\w[\\w.-]*/)*\\w[\\w.-]*\\.ttl");

  private final SourceGraph graph;
  private final Optional<Path> folder;

  /**
   * @param folder in which the home's file is; empty: it was not read from one
   */
  BroughtLanguages(SourceGraph graph, Optional<Path> folder) {
    this.graph = graph;
    this.folder = folder;
  }

  /** Adds the statements of the words' files to the graph. */
  void addWords(String base) {
    each(WORDS, (name, text) -> new SourceReader(graph, name, base).readTurtle(text));
  }

  /** The texts of grammars, by the tags of their languages, as the files are named. */
  Map<String, String> grammars() {
    Map<String, String> texts = new TreeMap<>();
    each(
        GRAMMAR,
        (name, text) -> {
          String file = name.substring(name.lastIndexOf('/') + 1);
          texts.put(file.substring(0, file.length() - ENDING.length()), text);
        });
    return texts;
  }

  private void each(Node property, BiConsumer<String, String> taken) {
    for (Node home : graph.subjectsWith(property)) {
      for (Node value : graph.objects(home, property)) {
        read(home, property, value)
            .ifPresent(text -> taken.accept(value.getLiteralLexicalForm(), text));
      }
    }
  }

  private Optional<String> read(Node home, Node property, Node value) {
    String name = value.isLiteral() ? value.getLiteralLexicalForm() : "";
    boolean isGrammar = property.equals(GRAMMAR);
    if (!(isGrammar ? A_GRAMMAR : SOME_WORDS).matcher(name).matches()) {
      fault(
          home,
          property,
          value,
          isGrammar ? "is no grammar" : "is no file of words",
          "name a file here or below such as \"%s\""
              .formatted(isGrammar ? "fr.grammar" : "fr.ttl"));
      return Optional.empty();
    }
    if (folder.isEmpty()) {
      fault(
          home,
          property,
          value,
          "cannot be found, as this home was not read from a file",
          "save the home beside it, and give the path of that file");
      return Optional.empty();
    }
    try {
      return Optional.of(Files.readString(folder.get().resolve(name)));
    } catch (IOException e) {
      fault(
          home,
          property,
          value,
          "cannot be read (" + e.getClass().getSimpleName() + ")",
          "put a file of that name, in UTF-8, beside the home's file");
      return Optional.empty();
    }
  }

  private void fault(Node home, Node property, Node value, String problem, String cure) {
    graph.fault(home, property, Optional.of(value), problem, cure);
  }
}
