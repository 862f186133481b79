package org.maestro.console.documents;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import java.util.List;
import org.maestro.agents.content.Words;
import org.maestro.ontology.home.WordList;

/** The words in which goals and questions can be put. */
public final class WordsDocument {
  private WordsDocument() {}

  /**
   * @param lines a word each, as the knowledge agent tells of them
   */
  public static JsonNode ofAnswer(List<Words> lines) {
    return of(
        lines.stream()
            .map(
                line ->
                    new WordList.Entry(
                        line.string("kind").orElse(""),
                        line.string("form").orElse(""),
                        line.string("meaning").orElse(""),
                        line.string("unit").orElse(""),
                        line.strings("devices")))
            .toList());
  }

  public static JsonNode of(List<WordList.Entry> words) {
    JsonMembers document = JsonMembers.empty();
    ArrayNode array = document.node().putArray("words");
    for (WordList.Entry word : words) {
      JsonMembers row =
          JsonMembers.in(array)
              .text("kind", word.kind())
              .text("word", word.name())
              .text("form", word.form());
      ArrayNode arguments = row.node().putArray("arguments");
      word.arguments()
          .forEach(
              argument ->
                  JsonMembers.in(arguments)
                      .text("variable", argument.name())
                      .text("class", argument.className()));
      row.text("meaning", word.meaning())
          .text("unit", word.unit())
          .words("devices", word.devices());
    }
    return document.node();
  }
}
