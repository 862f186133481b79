package org.maestro.ontology.reference;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** The reference of words for homes says what the ontology says, of every word. */
class ReferenceTest {
  private static final Path PAGE = Path.of("../docs/reference-homes.md");
  private static final Path CURRENT = Path.of("target/reference-homes.md");

  private static final String WRITE_ANEW =
      "docs/reference-homes.md is not what the ontology says now; write it anew: cp"
          + " ontology/target/reference-homes.md docs/";

  private final Ontology ontology = new Ontology();

  @Test
  void isCurrent() throws IOException {
    String page = new ReferencePage(ontology).text();
    Files.writeString(CURRENT, page);

    String written = Files.readString(PAGE);
    assertThat(linesOf(page, written)).as("%s; missing lines", WRITE_ANEW).isEmpty();
    assertThat(linesOf(written, page)).as("%s; lines too many", WRITE_ANEW).isEmpty();
    assertThat(written.equals(page)).as(WRITE_ANEW).isTrue();
  }

  private static List<String> linesOf(String page, String other) {
    Set<String> there = other.lines().collect(Collectors.toSet());
    return page.lines().filter(line -> !there.contains(line)).toList();
  }

  @Test
  void everyWordSaysWhatItMeans() {
    List<String> silent =
        ontology.sections().stream()
            .flatMap(section -> section.words().stream())
            .filter(word -> word.label().isEmpty() || word.comment().isEmpty())
            .map(Word::name)
            .toList();

    assertThat(silent).as("words without rdfs:label or rdfs:comment; write both").isEmpty();
  }

  @Test
  void everyDeclaredWordStandsInASection() {
    List<String> shown =
        ontology.sections().stream()
            .flatMap(section -> section.words().stream())
            .map(Word::name)
            .toList();

    assertThat(shown).doesNotHaveDuplicates().containsAll(ontology.declared());
  }
}
