package org.maestro.ontology.reference;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

/** The reference of words for homes says what the ontology says, of every word. */
class ReferenceTest {
  private static final Path PAGE = Path.of("../docs/reference-homes.md");
  private static final Path CURRENT = Path.of("target/reference-homes.md");

  private final Ontology ontology = new Ontology();

  @Test
  void isCurrent() throws IOException {
    String page = new ReferencePage(ontology).text();
    Files.writeString(CURRENT, page);

    assertThat(Files.exists(PAGE) ? Files.readString(PAGE) : "")
        .as(
            "docs/reference-homes.md is not what the ontology says now; write it anew: cp"
                + " ontology/target/reference-homes.md docs/")
        .isEqualTo(page);
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
