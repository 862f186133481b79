package org.maestro.ontology.reference;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;

/** The page: each word below its heading, with links between them. */
final class ReferencePage {
  private static final String BEFORE =
      """
      # Words for homes: the reference

      Every class, property and feature that a home may use, as the ontology says it (`ontology/src/main/resources/org/maestro/ontology/maestro.ttl`,
      `domain.ttl` and `household.ttl`, with what `check` asks for in `shapes.ttl` and `usual.ttl`). [The guide](guide-homes.md) tells which of them a home usually needs; the words of scenes stand in
      [the guide to scenes](guide-scenes.md). The page is made from these files, and `ReferenceTest` of the module `ontology` holds it against them.

      ```turtle
      @prefix : <https://w3id.org/maestro/domain#> .
      @prefix maestro: <https://w3id.org/maestro#> .
      @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
      @prefix xsd: <http://www.w3.org/2001/XMLSchema#> .
      ```

      Everything may have an `rdfs:label`, by which stories call it, and an `rdfs:comment`. *Required* is what a home is refused without, *usual* what `check` warns of.
      What a class says holds for its kinds, too. Examples are from shipped homes, or from the vocabulary itself.
      """;
  private static final Pattern LINK = Pattern.compile("\\[\\[([^]]+)]]");

  private final List<Section> sections;
  private final Map<String, String> anchors = new HashMap<>();

  ReferencePage(Ontology ontology) {
    this.sections = ontology.sections();
    Map<String, Integer> seen = new HashMap<>();
    for (Section section : sections) {
      anchor(section.heading(), seen);
      section.words().forEach(word -> anchors.put(word.name(), anchor(word.name(), seen)));
    }
  }

  /** As GitHub makes them of headings. */
  private static String anchor(String heading, Map<String, Integer> seen) {
    String slug = heading.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9 _-]", "").replace(' ', '-');
    int before = seen.merge(slug, 1, Integer::sum) - 1;
    return before == 0 ? slug : slug + "-" + before;
  }

  String text() {
    List<String> lines = new ArrayList<>();
    for (Section section : sections) {
      lines.add("\n## " + section.heading());
      section.words().forEach(word -> add(word, lines));
    }
    return BEFORE + String.join("\n", lines) + "\n";
  }

  private void add(Word word, List<String> lines) {
    lines.add("\n### " + word.name() + "\n");
    lines.add("*" + word.label() + "*: " + word.comment() + (word.traits().isEmpty() ? "" : "\n"));
    word.traits().forEach(trait -> lines.add("- " + linked(trait)));
  }

  private String linked(String trait) {
    return LINK.matcher(trait)
        .replaceAll(
            found ->
                anchors.containsKey(found.group(1))
                    ? "[`%s`](#%s)".formatted(found.group(1), anchors.get(found.group(1)))
                    : "`" + found.group(1) + "`");
  }
}
