package org.maestro.architecture;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** The map of the code names the packages that there are, and no others. */
class MapTest {
  private static final Path MAP = Path.of("../../docs/images/map.svg");
  private static final Pattern ROOM =
      Pattern.compile("font-size=\"(12.5|11.5)\"[^>]*>([a-z.]+)</text>");

  @Test
  void namesEveryPackage() throws IOException {
    Set<String> drawn =
        ROOM.matcher(Files.readString(MAP))
            .results()
            .map(room -> room.group(2))
            .collect(Collectors.toCollection(TreeSet::new));

    Set<String> packages = packages();
    assertThat(drawn)
        .containsAll(packages.stream().map(name -> shortest(name, drawn)).toList())
        .allMatch(room -> packages.stream().anyMatch(name -> isOf(room, name)));
  }

  private static boolean isOf(String room, String name) {
    return name.equals(room) || name.endsWith("." + room) || name.startsWith(room + ".");
  }

  /** By its last word, where it is drawn in the room that it belongs to. */
  private static String shortest(String name, Set<String> drawn) {
    return drawn.contains(name) ? name : name.substring(name.lastIndexOf('.') + 1);
  }

  private static Set<String> packages() {
    return new ClassFileImporter()
            .withImportOption(new ImportOption.DoNotIncludeTests())
            .importPackages("org.maestro")
            .stream()
            .map(type -> type.getPackageName().substring("org.maestro.".length()))
            .collect(Collectors.toCollection(TreeSet::new));
  }
}
