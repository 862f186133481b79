package org.maestro.experiment.assumptions;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * What a Javadoc comment in the sources says is assumed.
 *
 * @param type whose source it is
 * @param subject the constant or parameter of which it is said, with its value; empty: the type
 * @param sentences in which it is said
 */
record StatedInCode(String type, String subject, String sentences) {
  private static final Pattern COMMENT =
      Pattern.compile("/\\*\\*(.*?)\\*/\\s*(?=([^\\n]*(?:\\n[^\\n;{]*;)?))", Pattern.DOTALL);
  private static final Pattern CONSTANT =
      Pattern.compile(
          "(?:public |private )?static final \\S+ (\\w+) =\\s*([^;]+);", Pattern.DOTALL);
  private static final Pattern SENTENCE_END = Pattern.compile("(?<=\\.)\\s+(?=[A-Z])");
  private static final Pattern BLOCK = Pattern.compile("\\s@(?=param|return)");
  private static final String PARAMETER = "param ";
  private static final String ASSUMED = "assum";

  /** In the order of the files' names. */
  static List<StatedInCode> in(List<Path> directories) throws IOException {
    List<StatedInCode> all = new ArrayList<>();
    for (Path directory : directories) {
      try (Stream<Path> files = Files.walk(directory)) {
        files
            .filter(file -> file.toString().endsWith(".java"))
            .filter(file -> !file.endsWith("package-info.java"))
            .sorted()
            .forEach(file -> all.addAll(inFile(file)));
      }
    }
    return all;
  }

  private static List<StatedInCode> inFile(Path file) {
    String type = file.getFileName().toString().replace(".java", "");
    List<StatedInCode> found = new ArrayList<>();
    Matcher comment = COMMENT.matcher(read(file));
    while (comment.find()) {
      String text = comment.group(1).replaceAll("\\n\\s*\\*", " ").replaceAll("\\s+", " ").strip();
      Matcher constant = CONSTANT.matcher(comment.group(2));
      if (constant.lookingAt()) {
        if (isOfAssumptions(text)) {
          String value = constant.group(2).replaceAll("\\s+", " ");
          found.add(new StatedInCode(type, constant.group(1) + " = " + value, text));
        }
      } else {
        found.addAll(inBlocks(type, text));
      }
    }
    return found;
  }

  private static String read(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Of a comment's first part whole sentences, of a parameter's all. */
  private static List<StatedInCode> inBlocks(String type, String text) {
    List<StatedInCode> found = new ArrayList<>();
    for (String block : BLOCK.split(" " + text)) {
      if (!isOfAssumptions(block)) {
        continue;
      }
      if (block.startsWith(PARAMETER)) {
        String[] words = block.substring(PARAMETER.length()).split(" ", 2);
        found.add(new StatedInCode(type, words[0], words[1]));
      } else {
        String said =
            String.join(
                " ",
                Arrays.stream(SENTENCE_END.split(block.strip()))
                    .filter(StatedInCode::isOfAssumptions)
                    .toList());
        found.add(new StatedInCode(type, "", said));
      }
    }
    return found;
  }

  private static boolean isOfAssumptions(String text) {
    return text.toLowerCase(Locale.ROOT).contains(ASSUMED);
  }
}
