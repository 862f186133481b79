/**
 * The coordinator's journal and stories, and what people have answered to scripts, on disk: lines
 * that say what precedes them, forced before they count, read again after a crash. Entries flow in;
 * what was written, or what is damaged and where, flows out. What a journal amounts to is
 * coordination's business.
 */
@NullMarked
package org.maestro.platform.journal;

import org.jspecify.annotations.NullMarked;
