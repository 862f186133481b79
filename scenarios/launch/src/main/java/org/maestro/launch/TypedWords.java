package org.maestro.launch;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.Reader;
import java.util.List;
import org.maestro.language.Language;
import org.maestro.language.Understanding;
import org.maestro.language.reference.Situation;

/**
 * Words as somebody types them: each is understood when it is written, and again when letters are
 * taken back. A line is a sentence, and the next one is said after it. One thread only.
 */
final class TypedWords {
  private static final int END = 4;
  private static final int BACKSPACE = 8;
  private static final int DELETE = 127;

  private final Reader keys;
  private final PrintWriter out;
  private final boolean echoes;
  private final Language language;
  private final UnderstoodText text = new UnderstoodText();
  private final StringBuilder line = new StringBuilder();
  private Situation situation;
  private List<String> heard = List.of();
  private WordTable table;

  /**
   * @param echoes whether what is typed has to be shown here
   */
  TypedWords(Reader keys, PrintWriter out, boolean echoes, Language language, Situation situation) {
    this.keys = keys;
    this.out = out;
    this.echoes = echoes;
    this.language = language;
    this.situation = situation;
    this.table = new WordTable(language, situation);
  }

  /** Understands until nothing more is typed. */
  void understand() throws IOException {
    prompt();
    int key = keys.read();
    while (key >= 0 && key != END) {
      take((char) key);
      out.flush();
      key = keys.read();
    }
    if (!line.isEmpty()) {
      end();
    }
    out.flush();
  }

  private void take(char key) {
    if (key == '\r' || key == '\n') {
      if (!line.isEmpty()) {
        end();
        prompt();
      }
    } else if (key == BACKSPACE || key == DELETE) {
      takeBack();
    } else if (!Character.isISOControl(key)) {
      line.append(key);
      echo(Character.toString(key));
      if (Character.isWhitespace(key)) {
        written();
      }
    }
  }

  /** A word that was heard is open again. */
  private void takeBack() {
    if (!line.isEmpty()) {
      line.setLength(line.length() - 1);
      echo("\b \b");
    }
  }

  /** The words of the line are all there as they stand. */
  private void written() {
    List<String> words = language.words(line.toString());
    int known = heard.size();
    if (known > words.size() || !words.subList(0, known).equals(heard)) {
      table = new WordTable(language, situation);
      known = Math.max(0, words.size() - 1);
      words.subList(0, known).forEach(table::hear);
    }
    if (known < words.size()) {
      echo("\r\n");
      for (String word : words.subList(known, words.size())) {
        table.hear(word).forEach(this::print);
      }
      prompt();
      echo(line.toString());
    }
    heard = words;
  }

  private void print(List<String> row) {
    print("  %-14s %-18s %-44s  %s".formatted(row.toArray()).stripTrailing());
  }

  private void print(String shown) {
    out.print(shown + (echoes ? "\r\n" : System.lineSeparator()));
  }

  private void end() {
    written();
    echo("\r\n");
    Understanding understood = language.understand(line.toString().strip(), situation);
    text.lines(understood).forEach(this::print);
    situation = situation.after(understood.discourse(situation.discourse()));
    line.setLength(0);
    heard = List.of();
    table = new WordTable(language, situation);
  }

  private void prompt() {
    echo("> ");
  }

  private void echo(String shown) {
    if (echoes) {
      out.print(shown);
      out.flush();
    }
  }
}
