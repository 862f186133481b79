package org.maestro.sl;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** Reads a {@link PrintedScript}, line by line; blank lines are nothing. */
public final class PrintedScriptReader {
  private static final String WORD = "[^\\s,()\":=]+";
  private static final Pattern DECLARATION = Pattern.compile("(\\w+)\\s*:(?!=)\\s*(.*)");
  private static final Pattern CALL =
      Pattern.compile("(?:(" + WORD + ")\\s*:=\\s*)?(" + WORD + ")\\s*\\((.*)\\)");
  private static final Pattern ARGUMENT =
      Pattern.compile("\\s*(?:\"([^\"]*)\"|(" + WORD + "))\\s*(,|$)");
  private static final String A_STEP =
      "write a call, such as activateLights(livingroom) or show := queryPrefs(person)";

  private final Predicate<String> scripts;
  private final Set<String> agents = new LinkedHashSet<>();
  private final Set<String> names = new LinkedHashSet<>();
  private final Set<String> given = new HashSet<>();
  private final List<Step> steps = new ArrayList<>();

  /**
   * A call, and the name that is given what it returns.
   *
   * @param asked scripts whose values are wanted as arguments, as things are then
   */
  private record Step(Optional<String> assigned, Body.Run call, Set<String> asked) {}

  private PrintedScriptReader(Predicate<String> scripts) {
    this.scripts = scripts;
  }

  /**
   * The script of a text.
   *
   * @param scripts which names are scripts': as an argument, such as {@code currenttime}, one
   *     stands for what it returns
   * @throws PrintedScriptException when the text is anything else
   */
  public static PrintedScript read(String text, Predicate<String> scripts) {
    return new PrintedScriptReader(scripts).script(text.lines().map(String::strip).toList());
  }

  private PrintedScript script(List<String> lines) {
    Optional<String> title = Optional.empty();
    for (int at = 0; at < lines.size(); at++) {
      String line = lines.get(at);
      if (line.isEmpty()) {
        continue;
      }
      if (title.isEmpty()) {
        title = Optional.of(title(at + 1, line));
      } else {
        line(at + 1, line);
      }
    }
    int end = Math.max(1, lines.size());
    if (title.isEmpty()) {
      throw new PrintedScriptException(end, "ends without a script", "begin with script: NAME");
    }
    if (steps.isEmpty()) {
      throw new PrintedScriptException(end, "ends without a step", A_STEP);
    }
    names.stream()
        .filter(name -> !given.contains(name))
        .findFirst()
        .ifPresent(
            name -> {
              throw new PrintedScriptException(
                  end,
                  "ends without a value for the name " + name,
                  "give it one, %s := CALL, or declare it as agent: %s".formatted(name, name));
            });
    return new PrintedScript(title.get(), List.copyOf(agents), body());
  }

  private static String title(int at, String line) {
    Matcher declaration = DECLARATION.matcher(line);
    if (!declaration.matches() || !declaration.group(1).equals("script")) {
      throw new PrintedScriptException(
          at, "is \"%s\" where the script's name is wanted".formatted(line), "write script: NAME");
    }
    return word(at, declaration.group(2));
  }

  private void line(int at, String line) {
    Matcher declaration = DECLARATION.matcher(line);
    if (declaration.matches()) {
      declare(at, declaration.group(1), declaration.group(2));
      return;
    }
    Matcher call = CALL.matcher(line);
    if (!call.matches()) {
      throw new PrintedScriptException(at, "is \"%s\", which is no call".formatted(line), A_STEP);
    }
    step(at, Optional.ofNullable(call.group(1)), word(at, call.group(2)), call.group(3));
  }

  private void declare(int at, String kind, String text) {
    if (!kind.equals("agent") && !kind.equals("name")) {
      throw new PrintedScriptException(
          at, "declares the unknown kind " + kind, "write agent: NAME or name: NAME");
    }
    String name = word(at, text);
    if (!steps.isEmpty()) {
      throw new PrintedScriptException(
          at, "declares %s after a call".formatted(name), "write it before the first call");
    }
    if (agents.contains(name) || names.contains(name)) {
      throw new PrintedScriptException(at, "declares %s again".formatted(name), "keep one of both");
    }
    (kind.equals("agent") ? agents : names).add(name);
  }

  private static String word(int at, String text) {
    if (!SlReader.isName(text) || SlReader.isNumber(text)) {
      throw new PrintedScriptException(
          at, "has \"%s\" where a name is wanted".formatted(text), "write one name there");
    }
    return text;
  }

  private void step(int at, Optional<String> assigned, String script, String text) {
    Set<String> asked = new LinkedHashSet<>();
    List<Term> arguments = arguments(at, text, asked);
    assigned
        .filter(name -> !names.contains(name))
        .ifPresent(
            name -> {
              throw new PrintedScriptException(
                  at,
                  "gives a value to %s, which is no name of the script".formatted(name),
                  "declare it above, name: " + name);
            });
    assigned.ifPresent(given::add);
    steps.add(new Step(assigned, new Body.Run(script, arguments), asked));
  }

  private List<Term> arguments(int at, String text, Set<String> asked) {
    List<Term> terms = new ArrayList<>();
    Matcher argument = ARGUMENT.matcher(text);
    int read = 0;
    boolean isMore = !text.isBlank();
    while (isMore) {
      if (!argument.find(read) || argument.start() != read) {
        throw noArgument(at, text.substring(read).strip());
      }
      terms.add(
          argument.group(1) != null
              ? new Term.Text(argument.group(1))
              : term(at, argument.group(2), asked));
      read = argument.end();
      isMore = argument.group(3).equals(",");
    }
    return terms;
  }

  private Term term(int at, String word, Set<String> asked) {
    if (names.contains(word) && !given.contains(word)) {
      throw new PrintedScriptException(
          at, "uses %s, which has no value yet".formatted(word), "give it one before that line");
    }
    if (agents.contains(word) || names.contains(word)) {
      return new Term.Variable(word);
    }
    if (scripts.test(word)) {
      asked.add(word);
      return new Term.Variable(word);
    }
    if (SlReader.isNumber(word) ? !isFinite(word) : !SlReader.isName(word)) {
      throw noArgument(at, word);
    }
    return SlParser.term(word);
  }

  private static boolean isFinite(String number) {
    return Double.isFinite(Double.parseDouble(number));
  }

  private static PrintedScriptException noArgument(int at, String found) {
    return new PrintedScriptException(
        at,
        "has \"%s\" where an argument is wanted".formatted(found),
        "write a name, a number or a text in quotes, with commas between them");
  }

  private Body body() {
    List<Body> following = List.of();
    for (int at = steps.size() - 1; at >= 0; at--) {
      following = before(steps.get(at), following);
    }
    return following.size() == 1 ? following.get(0) : new Body.Seq(following);
  }

  /** The step, and all that follows it. What nobody uses is not given a name. */
  private static List<Body> before(Step step, List<Body> following) {
    List<Body> all =
        step.assigned().isPresent() && !following.isEmpty()
            ? List.of(new Body.Let(step.assigned().get(), step.call(), following))
            : Stream.concat(Stream.of(step.call()), following.stream()).toList();
    for (String script : step.asked()) {
      all = List.of(new Body.Let(script, new Body.Run(script, List.of()), all));
    }
    return all;
  }
}
