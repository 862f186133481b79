package org.maestro.guide;

import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;

/** A page in Markdown: where it links to, and what it can be linked to at. */
record Page(Path file, String text) {
  /** What is built, fetched, or written by who tries README.md. */
  private static final Set<String> NOT_OURS = Set.of("target", ".git", "mine", "node_modules");

  private static final Pattern BLOCK =
      Pattern.compile("^ *```.*?^ *```", Pattern.MULTILINE | Pattern.DOTALL);
  private static final Pattern CODE = Pattern.compile("`[^`\n]*`");
  private static final Pattern LINK = Pattern.compile("]\\(<?([^)\\s>]+)>?(?: \"[^\"]*\")?\\)");
  private static final Pattern HEADING = Pattern.compile("^#{1,6} +(.+?)#*$", Pattern.MULTILINE);
  private static final Pattern ELSEWHERE = Pattern.compile("^[a-z]+:.*");

  static Page read(Path file) throws IOException {
    return new Page(file, Files.readString(file));
  }

  static List<Page> all(Path root) throws IOException {
    List<Page> pages = new ArrayList<>();
    Files.walkFileTree(
        root,
        new SimpleFileVisitor<>() {
          @Override
          public FileVisitResult preVisitDirectory(Path directory, BasicFileAttributes about) {
            return NOT_OURS.contains(directory.getFileName().toString())
                ? FileVisitResult.SKIP_SUBTREE
                : FileVisitResult.CONTINUE;
          }

          @Override
          public FileVisitResult visitFile(Path file, BasicFileAttributes about)
              throws IOException {
            if (file.toString().endsWith(".md")) {
              pages.add(read(file));
            }
            return FileVisitResult.CONTINUE;
          }
        });
    return pages;
  }

  /** All links but those to other sites. */
  List<String> links() {
    // What a link is called may be code, and is not looked at.
    String prose = CODE.matcher(BLOCK.matcher(text).replaceAll("")).replaceAll("");
    return LINK.matcher(prose)
        .results()
        .map(found -> found.group(1))
        .filter(link -> !ELSEWHERE.matcher(link).matches())
        .toList();
  }

  /** The file or directory that the link names, whether it is there or not. */
  Path target(String link) {
    String path = link.replaceAll("#.*", "");
    return path.isEmpty() ? file : file.resolveSibling(path).normalize();
  }

  /** Why the link leads nowhere. */
  Optional<String> objection(String link) throws IOException {
    Path target = target(link);
    if (!Files.exists(target)) {
      return Optional.of("which is not there");
    }
    int hash = link.indexOf('#');
    if (hash < 0 || !target.toString().endsWith(".md")) {
      return Optional.empty();
    }
    return read(target).anchors().contains(link.substring(hash + 1))
        ? Optional.empty()
        : Optional.of("which has no such heading");
  }

  /** As GitHub makes them of headings. */
  private Set<String> anchors() {
    Set<String> anchors = new HashSet<>();
    Map<String, Integer> seen = new HashMap<>();
    HEADING
        .matcher(BLOCK.matcher(text).replaceAll(""))
        .results()
        .map(found -> slug(found.group(1).strip()))
        .forEach(
            slug -> {
              int before = seen.merge(slug, 1, Integer::sum) - 1;
              anchors.add(before == 0 ? slug : slug + "-" + before);
            });
    return anchors;
  }

  private static String slug(String heading) {
    return heading
        .replaceAll("\\[([^]]*)]\\([^)]*\\)", "$1")
        .toLowerCase(Locale.ROOT)
        .replaceAll("[^\\p{L}\\p{N} _-]", "")
        .replace(' ', '-');
  }
}
