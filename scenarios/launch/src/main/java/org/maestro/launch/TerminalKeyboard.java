package org.maestro.launch;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Function;
import org.jline.reader.Candidate;
import org.jline.reader.EndOfFileException;
import org.jline.reader.LineReader;
import org.jline.reader.LineReaderBuilder;
import org.jline.reader.UserInterruptException;
import org.jline.reader.Widget;
import org.jline.reader.impl.DefaultParser;
import org.jline.terminal.Terminal;
import org.maestro.text.VisibleText;

/**
 * A terminal on which a line can be edited and fetched again, and what could come next is shown as
 * one types.
 */
final class TerminalKeyboard implements Keyboard {
  private static final int MOST_UNASKED = 24;

  private final Terminal terminal;
  private final LineReader reader;
  private final String prompt;

  /** Only who asks is shown more words. Of the thread that reads. */
  private boolean isAsked;

  /**
   * @param nextWords words with which what is written could go on
   */
  TerminalKeyboard(Terminal terminal, String prompt, Function<String, List<String>> nextWords) {
    this.terminal = terminal;
    this.prompt = prompt;
    DefaultParser parser = new DefaultParser();
    // An apostrophe is one.
    parser.setQuoteChars(new char[0]);
    parser.setEscapeChars(new char[0]);
    this.reader =
        LineReaderBuilder.builder()
            .terminal(terminal)
            .parser(parser)
            .completer(
                (line, parsed, candidates) -> {
                  List<String> words = nextWords.apply(parsed.line().substring(0, parsed.cursor()));
                  if (isAsked || words.size() <= MOST_UNASKED) {
                    words.forEach(word -> candidates.add(new Candidate(word)));
                  }
                })
            .option(LineReader.Option.DISABLE_EVENT_EXPANSION, true)
            .option(LineReader.Option.CASE_INSENSITIVE, true)
            .variable(LineReader.BELL_STYLE, "none")
            .build();
    reader.setAutosuggestion(LineReader.SuggestionType.COMPLETER);
    Widget completion =
        Objects.requireNonNull(reader.getWidgets().get(LineReader.EXPAND_OR_COMPLETE));
    reader.getWidgets().put(LineReader.EXPAND_OR_COMPLETE, () -> asked(completion));
  }

  /** Who asks for words is shown all of them. */
  private boolean asked(Widget completion) {
    isAsked = true;
    try {
      return completion.apply();
    } finally {
      isAsked = false;
    }
  }

  @Override
  public Optional<String> line() {
    while (true) {
      try {
        return Optional.of(reader.readLine(prompt));
      } catch (UserInterruptException e) {
        // The line is given up, and another begun.
      } catch (EndOfFileException e) {
        return Optional.empty();
      }
    }
  }

  @Override
  public void print(String line) {
    reader.printAbove(VisibleText.lines(line));
  }

  @Override
  public boolean isWrittenByHand() {
    return true;
  }

  @Override
  public void close() {
    try {
      terminal.close();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
