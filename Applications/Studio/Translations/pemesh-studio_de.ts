<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Preferences</name>
    <message>
        <source>Theme</source>
        <translation>Thema</translation>
    </message>
    <message>
        <source>Colours of the window</source>
        <translation>Farben des Fensters</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Size of text</source>
        <translation>Schriftgröße</translation>
    </message>
    <message>
        <source>Of the window and of charts on the screen</source>
        <translation>Des Fensters und der Diagramme auf dem Bildschirm</translation>
    </message>
    <message>
        <source> pt</source>
        <translation> pt</translation>
    </message>
    <message>
        <source>Keep unsaved work after</source>
        <translation>Ungesichertes aufheben nach</translation>
    </message>
    <message>
        <source>How long after a change the study is kept for the case that the program ends by accident</source>
        <translation>Wie lange nach einer Änderung die Studie aufgehoben wird für den Fall, dass das Programm versehentlich endet</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Meshes at a time</source>
        <translation>Gitter zugleich</translation>
    </message>
    <message>
        <source>How many meshes of a study are made and solved at the same time</source>
        <translation>Wie viele Gitter einer Studie gleichzeitig erzeugt und gelöst werden</translation>
    </message>
    <message>
        <source>As many as the machine has cores</source>
        <translation>So viele wie Prozessorkerne</translation>
    </message>
    <message>
        <source>Recent studies</source>
        <translation>Zuletzt geöffnete Studien</translation>
    </message>
    <message>
        <source>How many the menu File lists; 0 forgets them</source>
        <translation>Wie viele das Menü Datei nennt; 0 vergisst sie</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Makes families of polygonal meshes, measures them, solves on them, and shows what geometry does to the solution.</source>
        <translation>Erzeugt Familien von Polygongittern, misst sie, löst auf ihnen und zeigt, was die Geometrie mit der Lösung macht.</translation>
    </message>
    <message>
        <source>A study (.json), or one or more meshes.</source>
        <translation>Eine Studie (.json) oder ein oder mehrere Gitter.</translation>
    </message>
</context>
<context>
    <name>pemesh::CorrelationModel</name>
    <message>
        <source>%1 and %2: Spearman %3</source>
        <translation>%1 und %2: Spearman %3</translation>
    </message>
</context>
<context>
    <name>pemesh::CorrelationPage</name>
    <message>
        <source>What drives what?</source>
        <translation>Was bestimmt was?</translation>
    </message>
    <message>
        <source>Run a study with a solver: every metric of the meshes is then set against every performance of the solver, and the strongest relations are listed here in words.</source>
        <translation>Führen Sie eine Studie mit einem Löser aus: Jede Metrik der Gitter wird dann jeder Leistung des Lösers gegenübergestellt, und die stärksten Zusammenhänge stehen hier in Worten.</translation>
    </message>
    <message>
        <source>Run with a solver</source>
        <translation>Mit einem Löser ausführen</translation>
    </message>
    <message>
        <source>%1: double click to see the mesh</source>
        <translation>%1: Doppelklick zeigt das Gitter</translation>
    </message>
    <message>
        <source>log</source>
        <translation>log</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Logarithmic x axis</source>
        <translation>Logarithmische x-Achse</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Logarithmic y axis</source>
        <translation>Logarithmische y-Achse</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Export the chart</source>
        <translation>Diagramm exportieren</translation>
    </message>
    <message>
        <source>Only those that mention …</source>
        <translation>Nur solche, die dies erwähnen …</translation>
    </message>
    <message>
        <source>Filter of the relations</source>
        <translation>Filter der Zusammenhänge</translation>
    </message>
    <message>
        <source>Strongest relations</source>
        <translation>Stärkste Zusammenhänge</translation>
    </message>
    <message>
        <source>Matrix of correlations</source>
        <translation>Matrix der Korrelationen</translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation>Matrix</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>No relation mentions &quot;%1&quot;.</source>
        <translation>Kein Zusammenhang erwähnt „%1“.</translation>
    </message>
    <message>
        <source>There is nothing to say yet: relations are found between the metrics of three meshes or more and the performances of a solver.</source>
        <translation>Noch gibt es nichts zu sagen: Zusammenhänge bestehen zwischen den Metriken von mindestens drei Gittern und den Leistungen eines Lösers.</translation>
    </message>
</context>
<context>
    <name>pemesh::ElementTableModel</name>
    <message>
        <source>Element</source>
        <translation>Element</translation>
    </message>
</context>
<context>
    <name>pemesh::FailureList</name>
    <message>
        <source>Mesh</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Abschnitt</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Was geschah</translation>
    </message>
    <message>
        <source>Failures</source>
        <translation>Fehlschläge</translation>
    </message>
    <message>
        <source>The solver wrote nothing.</source>
        <translation>Der Löser schrieb nichts.</translation>
    </message>
    <message>
        <source>What the solver wrote</source>
        <translation>Was der Löser schrieb</translation>
    </message>
    <message>
        <source>No failures.</source>
        <translation>Keine Fehlschläge.</translation>
    </message>
    <message>
        <source>Select a failure to read it.</source>
        <translation>Wählen Sie einen Fehlschlag, um ihn zu lesen.</translation>
    </message>
    <message>
        <source>

Its files are in %1</source>
        <translation>

Seine Dateien sind in %1</translation>
    </message>
</context>
<context>
    <name>pemesh::FamilyGallery</name>
    <message>
        <source>Draw</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>Draw a polygon by hand: drag around it, or click its corners (D)</source>
        <translation>Ein Polygon von Hand zeichnen: rundherum ziehen oder seine Ecken anklicken (D)</translation>
    </message>
    <message>
        <source>From file</source>
        <translation>Aus Datei</translation>
    </message>
    <message>
        <source>Add the polygon of a file: OFF, OBJ, STL, NODE, VTP, or points as CSV</source>
        <translation>Das Polygon einer Datei hinzufügen: OFF, OBJ, STL, NODE, VTP oder Punkte als CSV</translation>
    </message>
</context>
<context>
    <name>pemesh::GeometryPage</name>
    <message>
        <source>Mesh</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>All metrics over the data set</source>
        <translation>Alle Metriken über den Datensatz</translation>
    </message>
    <message>
        <source>Metric against metric</source>
        <translation>Metrik gegen Metrik</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Metrik</translation>
    </message>
    <message>
        <source>Against</source>
        <translation>Gegen</translation>
    </message>
    <message>
        <source>Metric </source>
        <translation>Metrik </translation>
    </message>
    <message>
        <source> against </source>
        <translation> gegen </translation>
    </message>
    <message>
        <source>Mark the smallest and the largest value</source>
        <translation>Kleinsten und größten Wert markieren</translation>
    </message>
    <message>
        <source>One scale for all meshes of the data set</source>
        <translation>Eine Skala für alle Gitter des Datensatzes</translation>
    </message>
    <message>
        <source>log</source>
        <translation>log</translation>
    </message>
    <message>
        <source>Logarithmic colours</source>
        <translation>Logarithmische Farben</translation>
    </message>
    <message>
        <source>Export this view</source>
        <translation>Diese Ansicht exportieren</translation>
    </message>
    <message>
        <source>There is no mesh: place polygons on the page Mesh, or open meshes.</source>
        <translation>Es gibt kein Gitter: Setzen Sie Polygone auf der Seite Gitter, oder öffnen Sie Gitter.</translation>
    </message>
    <message>
        <source>There is no mesh with metrics to show.</source>
        <translation>Es gibt kein Gitter mit Metriken.</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Elemente</translation>
    </message>
    <message>
        <source>Preview of the study</source>
        <translation>Vorschau der Studie</translation>
    </message>
    <message>
        <source>Results in %1</source>
        <translation>Ergebnisse in %1</translation>
    </message>
    <message>
        <source>Export the mesh</source>
        <translation>Gitter exportieren</translation>
    </message>
    <message>
        <source>PDF (*.pdf);;SVG (*.svg);;PNG (*.png);;Table of the elements (*.csv)</source>
        <translation>PDF (*.pdf);;SVG (*.svg);;PNG (*.png);;Tabelle der Elemente (*.csv)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
</context>
<context>
    <name>pemesh::LayoutCanvas</name>
    <message>
        <source>Canvas of the polygons</source>
        <translation>Zeichenfläche der Polygone</translation>
    </message>
    <message>
        <source>Move polygon</source>
        <translation>Polygon verschieben</translation>
    </message>
    <message>
        <source>Scale polygon</source>
        <translation>Polygon skalieren</translation>
    </message>
    <message>
        <source>Turn polygon</source>
        <translation>Polygon drehen</translation>
    </message>
</context>
<context>
    <name>pemesh::LogDock</name>
    <message>
        <source>Log and values</source>
        <translation>Protokoll und Werte</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Of the mesh in view</source>
        <translation>Des sichtbaren Gitters</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Elemente</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Element %1: %2</source>
        <translation>Element %1: %2</translation>
    </message>
</context>
<context>
    <name>pemesh::MeshCanvas</name>
    <message>
        <source>Mesh</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>Element %1: %2</source>
        <translation>Element %1: %2</translation>
    </message>
    <message>
        <source>min %1</source>
        <translation>min %1</translation>
    </message>
    <message>
        <source>max %1</source>
        <translation>max %1</translation>
    </message>
</context>
<context>
    <name>pemesh::MeshChoiceDialog</name>
    <message>
        <source>Mesh</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>Run some meshes</source>
        <translation>Einige Gitter ausführen</translation>
    </message>
    <message>
        <source>Select the meshes to run (with Ctrl or Shift several). The results hold these alone.</source>
        <translation>Wählen Sie die Gitter (mit Strg oder Umschalt mehrere). Die Ergebnisse enthalten nur diese.</translation>
    </message>
    <message>
        <source>Meshes</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>Run one mesh</source>
        <translation>Ein Gitter ausführen</translation>
    </message>
    <message>
        <source>Run %1 meshes</source>
        <translation>%1 Gitter ausführen</translation>
    </message>
</context>
<context>
    <name>pemesh::MeshPage</name>
    <message>
        <source>Add a polygon</source>
        <translation>Polygon hinzufügen</translation>
    </message>
    <message>
        <source>Add the polygon of a file</source>
        <translation>Das Polygon einer Datei hinzufügen</translation>
    </message>
    <message>
        <source>Polygons (%1 *.csv *.txt *.xy);;All files (*)</source>
        <translation>Polygone (%1 *.csv *.txt *.xy);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Draw polygon</source>
        <translation>Polygon zeichnen</translation>
    </message>
    <message>
        <source>Select and move</source>
        <translation>Auswählen und verschieben</translation>
    </message>
    <message>
        <source>Draw a polygon</source>
        <translation>Ein Polygon zeichnen</translation>
    </message>
    <message>
        <source>Snap to the grid</source>
        <translation>Am Raster ausrichten</translation>
    </message>
    <message>
        <source>Snap to the grid (G)</source>
        <translation>Am Raster ausrichten (G)</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>Show all (Home)</source>
        <translation>Alles zeigen (Pos1)</translation>
    </message>
    <message>
        <source>Duplicate polygon</source>
        <translation>Polygon verdoppeln</translation>
    </message>
    <message>
        <source>Delete polygon</source>
        <translation>Polygon löschen</translation>
    </message>
    <message>
        <source>Move polygon up in the list</source>
        <translation>Polygon in der Liste nach oben</translation>
    </message>
    <message>
        <source>Move polygon down in the list</source>
        <translation>Polygon in der Liste nach unten</translation>
    </message>
    <message>
        <source>Polygons</source>
        <translation>Polygone</translation>
    </message>
    <message>
        <source>Select a polygon on the canvas or in the table to change it.</source>
        <translation>Wählen Sie ein Polygon auf der Zeichenfläche oder in der Tabelle, um es zu ändern.</translation>
    </message>
    <message>
        <source>Domain</source>
        <translation>Gebiet</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>Sweep</source>
        <translation>Variation</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Add polygon of a file</source>
        <translation>Polygon einer Datei hinzufügen</translation>
    </message>
    <message>
        <source>Move polygon up</source>
        <translation>Polygon nach oben</translation>
    </message>
    <message>
        <source>Move polygon down</source>
        <translation>Polygon nach unten</translation>
    </message>
    <message>
        <source>%L1 elements, %L2 vertices</source>
        <translation>%L1 Elemente, %L2 Knoten</translation>
    </message>
    <message>
        <source>Pick a polygon on the left or draw one.
Mesh files and studies can be dropped here.</source>
        <translation>Wählen Sie links ein Polygon oder zeichnen Sie eines.
Gitterdateien und Studien können hier abgelegt werden.</translation>
    </message>
</context>
<context>
    <name>pemesh::MetricCharts</name>
    <message>
        <source>All metrics over the data set</source>
        <translation>Alle Metriken über den Datensatz</translation>
    </message>
    <message>
        <source>Run the study to measure every mesh of it. The charts then show the smallest, mean and largest value of each metric.</source>
        <translation>Führen Sie die Studie aus, um jedes ihrer Gitter zu messen. Die Diagramme zeigen dann kleinsten, mittleren und größten Wert jeder Metrik.</translation>
    </message>
    <message>
        <source>Run the study</source>
        <translation>Studie ausführen</translation>
    </message>
    <message>
        <source>Meshes in the order of</source>
        <translation>Gitter in der Reihenfolge</translation>
    </message>
    <message>
        <source>Order of the meshes</source>
        <translation>Reihenfolge der Gitter</translation>
    </message>
    <message>
        <source>Charts of all metrics</source>
        <translation>Diagramme aller Metriken</translation>
    </message>
    <message>
        <source>the study</source>
        <translation>der Studie</translation>
    </message>
    <message>
        <source>the smallest %1</source>
        <translation>des kleinsten %1</translation>
    </message>
    <message>
        <source>the mean %1</source>
        <translation>des mittleren %1</translation>
    </message>
    <message>
        <source>the largest %1</source>
        <translation>des größten %1</translation>
    </message>
    <message>
        <source>meshes by %1</source>
        <translation>Gitter nach %1</translation>
    </message>
</context>
<context>
    <name>pemesh::OptionForm</name>
    <message>
        <source>Back to the default</source>
        <translation>Zurück zur Vorgabe</translation>
    </message>
    <message>
        <source>Default of %1</source>
        <translation>Vorgabe von %1</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>File of %1</source>
        <translation>Datei von %1</translation>
    </message>
</context>
<context>
    <name>pemesh::PanelView</name>
    <message>
        <source>Charts</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>There is nothing to export.</source>
        <translation>Es gibt nichts zu exportieren.</translation>
    </message>
    <message>
        <source>Export figure</source>
        <translation>Abbildung exportieren</translation>
    </message>
    <message>
        <source>PDF (*.pdf);;SVG (*.svg);;PNG (*.png);;Numbers of the figure (*.csv)</source>
        <translation>PDF (*.pdf);;SVG (*.svg);;PNG (*.png);;Zahlen der Abbildung (*.csv)</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>Export all of it …</source>
        <translation>Alles exportieren …</translation>
    </message>
    <message>
        <source>Export this one …</source>
        <translation>Dieses exportieren …</translation>
    </message>
</context>
<context>
    <name>pemesh::PolygonTableModel</name>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maß</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name polygon</source>
        <translation>Polygon benennen</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
</context>
<context>
    <name>pemesh::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
</context>
<context>
    <name>pemesh::RunBox</name>
    <message>
        <source>Run all meshes</source>
        <translation>Alle Gitter ausführen</translation>
    </message>
    <message>
        <source>Run the study (F5)</source>
        <translation>Studie ausführen (F5)</translation>
    </message>
    <message>
        <source>Run some …</source>
        <translation>Einige ausführen …</translation>
    </message>
    <message>
        <source>Choose the meshes to run (Alt+F5)</source>
        <translation>Gitter auswählen und ausführen (Alt+F5)</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>End the work for now, to be continued, also after the program was ended</source>
        <translation>Die Arbeit für jetzt beenden, um sie fortzusetzen, auch nach dem Ende des Programms</translation>
    </message>
    <message>
        <source>Stop and keep</source>
        <translation>Beenden und behalten</translation>
    </message>
    <message>
        <source>End the run and keep the meshes that are done</source>
        <translation>Den Lauf beenden und die fertigen Gitter behalten</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>End the run and keep the results of the run before</source>
        <translation>Den Lauf beenden und die Ergebnisse des vorigen Laufs behalten</translation>
    </message>
    <message>
        <source>Progress of the run</source>
        <translation>Fortschritt des Laufs</translation>
    </message>
    <message>
        <source>Running, %1 s</source>
        <translation>Läuft, %1 s</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Paused: what is done is kept until you continue</source>
        <translation>Pause: Was fertig ist, bleibt, bis Sie fortsetzen</translation>
    </message>
</context>
<context>
    <name>pemesh::RunDesk</name>
    <message>
        <source>Run study</source>
        <translation>Studie ausführen</translation>
    </message>
    <message>
        <source>Run the &amp;solver</source>
        <translation>Den &amp;Löser ausführen</translation>
    </message>
    <message>
        <source>Run some &amp;meshes …</source>
        <translation>Einige &amp;Gitter ausführen …</translation>
    </message>
    <message>
        <source>Pause the run</source>
        <translation>Den Lauf anhalten</translation>
    </message>
    <message>
        <source>Stop and keep what is done</source>
        <translation>Beenden und behalten, was fertig ist</translation>
    </message>
    <message>
        <source>Cancel the run</source>
        <translation>Den Lauf abbrechen</translation>
    </message>
    <message>
        <source>Run the study, with the solver %1 where it names none (Ctrl+R)</source>
        <translation>Die Studie ausführen, mit dem Löser %1, wo sie keinen nennt (Strg+R)</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Continue the run that was paused (F5)</source>
        <translation>Den angehaltenen Lauf fortsetzen (F5)</translation>
    </message>
    <message>
        <source>Run study (F5)</source>
        <translation>Studie ausführen (F5)</translation>
    </message>
    <message>
        <source>Running …</source>
        <translation>Läuft …</translation>
    </message>
    <message>
        <source>Meshing …</source>
        <translation>Gitter entsteht …</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Continuing %1</source>
        <translation>%1 wird fortgesetzt</translation>
    </message>
    <message>
        <source>Running %1</source>
        <translation>%1 wird ausgeführt</translation>
    </message>
    <message>
        <source>Running %1, meshes chosen: %2</source>
        <translation>%1 wird ausgeführt, gewählte Gitter: %2</translation>
    </message>
    <message>
        <source>Paused after %1 s: Run continues it, now or when the study is opened again.</source>
        <translation>Pause nach %1 s: Ausführen setzt fort, jetzt oder wenn die Studie wieder geöffnet wird.</translation>
    </message>
    <message>
        <source>The run was ended and nothing was kept.</source>
        <translation>Der Lauf wurde beendet, und nichts wurde behalten.</translation>
    </message>
    <message>
        <source>Done in %1 s: %2</source>
        <translation>Fertig nach %1 s: %2</translation>
    </message>
    <message>
        <source>A run of this study did not end: Run continues it, Cancel gives it up.</source>
        <translation>Ein Lauf dieser Studie kam nicht zum Ende: Ausführen setzt ihn fort, Abbrechen gibt ihn auf.</translation>
    </message>
</context>
<context>
    <name>pemesh::Session</name>
    <message>
        <source>Meshes (%1)</source>
        <translation>Gitter (%1)</translation>
    </message>
    <message>
        <source>Unsaved study</source>
        <translation>Ungesicherte Studie</translation>
    </message>
    <message>
        <source>PEMesh Studio ended without saving %1, last changed on %2. Bring it back?</source>
        <translation>PEMesh Studio endete, ohne %1 zu sichern, zuletzt geändert am %2. Wiederherstellen?</translation>
    </message>
    <message>
        <source>a new study</source>
        <translation>eine neue Studie</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungesicherte Änderungen</translation>
    </message>
    <message>
        <source>%1 has changes that are not saved.</source>
        <translation>%1 hat Änderungen, die nicht gesichert sind.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open study</source>
        <translation>Studie öffnen</translation>
    </message>
    <message>
        <source>Studies (*.json);;All files (*)</source>
        <translation>Studien (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open meshes</source>
        <translation>Gitter öffnen</translation>
    </message>
    <message>
        <source>;;All files (*)</source>
        <translation>;;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Sichern</translation>
    </message>
    <message>
        <source>Save study</source>
        <translation>Studie sichern</translation>
    </message>
    <message>
        <source>Studies (*.json)</source>
        <translation>Studien (*.json)</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Noch keine</translation>
    </message>
</context>
<context>
    <name>pemesh::SolverPage</name>
    <message>
        <source>Solvers</source>
        <translation>Löser</translation>
    </message>
    <message>
        <source>Runs of solvers</source>
        <translation>Läufe von Lösern</translation>
    </message>
    <message>
        <source>Known solvers</source>
        <translation>Bekannte Löser</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add from a file</source>
        <translation>Aus einer Datei hinzufügen</translation>
    </message>
    <message>
        <source>Add a solver described by a file</source>
        <translation>Einen Löser hinzufügen, den eine Datei beschreibt</translation>
    </message>
    <message>
        <source>Description of a solver</source>
        <translation>Beschreibung eines Lösers</translation>
    </message>
    <message>
        <source>Descriptions (*.json)</source>
        <translation>Beschreibungen (*.json)</translation>
    </message>
    <message>
        <source>Remove solver</source>
        <translation>Löser entfernen</translation>
    </message>
    <message>
        <source>Remove the selected solver</source>
        <translation>Den gewählten Löser entfernen</translation>
    </message>
    <message>
        <source>Run that is shown</source>
        <translation>Gezeigter Lauf</translation>
    </message>
    <message>
        <source>Surfaces …</source>
        <translation>Flächen …</translation>
    </message>
    <message>
        <source>Solution and ground truth as surfaces, in a window of their own</source>
        <translation>Lösung und wahre Lösung als Flächen in einem eigenen Fenster</translation>
    </message>
    <message>
        <source>Add a solver and run the study: the solution, the ground truth and the error of each mesh are shown here.</source>
        <translation>Fügen Sie einen Löser hinzu und führen Sie die Studie aus: Lösung, wahre Lösung und Fehler jedes Gitters werden hier gezeigt.</translation>
    </message>
    <message>
        <source>Solution, ground truth and error</source>
        <translation>Lösung, wahre Lösung und Fehler</translation>
    </message>
    <message>
        <source>Charts of the performances</source>
        <translation>Diagramme der Leistungen</translation>
    </message>
    <message>
        <source>Run the study with a solver: its performances over the meshes are shown here.</source>
        <translation>Führen Sie die Studie mit einem Löser aus: Seine Leistungen über die Gitter werden hier gezeigt.</translation>
    </message>
    <message>
        <source>Solution</source>
        <translation>Lösung</translation>
    </message>
    <message>
        <source>Performances</source>
        <translation>Leistungen</translation>
    </message>
    <message>
        <source>Failures</source>
        <translation>Fehlschläge</translation>
    </message>
    <message>
        <source>Add solver</source>
        <translation>Löser hinzufügen</translation>
    </message>
    <message>
        <source>Failures (%1)</source>
        <translation>Fehlschläge (%1)</translation>
    </message>
</context>
<context>
    <name>pemesh::StudioMenus</name>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>Pre&amp;ferences …</source>
        <translation>&amp;Einstellungen …</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Ausführen</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;New study</source>
        <translation>&amp;Neue Studie</translation>
    </message>
    <message>
        <source>&amp;Open study …</source>
        <translation>Studie &amp;öffnen …</translation>
    </message>
    <message>
        <source>Open &amp;meshes …</source>
        <translation>&amp;Gitter öffnen …</translation>
    </message>
    <message>
        <source>&amp;Recent studies</source>
        <translation>&amp;Zuletzt geöffnete Studien</translation>
    </message>
    <message>
        <source>Open res&amp;ults …</source>
        <translation>&amp;Ergebnisse öffnen …</translation>
    </message>
    <message>
        <source>Save study &amp;as …</source>
        <translation>Studie sichern &amp;unter …</translation>
    </message>
    <message>
        <source>Save m&amp;esh …</source>
        <translation>G&amp;itter sichern …</translation>
    </message>
    <message>
        <source>Save &amp;polygons as a table …</source>
        <translation>&amp;Polygone als Tabelle sichern …</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>An&amp;sicht</translation>
    </message>
    <message>
        <source>&amp;Plot settings …</source>
        <translation>&amp;Diagramme einrichten …</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Thema</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Reference of the &amp;metrics</source>
        <translation>Referenz der &amp;Metriken</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Metriken</translation>
    </message>
    <message>
        <source>Reference of the &amp;study document</source>
        <translation>Referenz des &amp;Studiendokuments</translation>
    </message>
    <message>
        <source>The keys of a study</source>
        <translation>Die Schlüssel einer Studie</translation>
    </message>
    <message>
        <source>&amp;About PEMesh Studio</source>
        <translation>Ü&amp;ber PEMesh Studio</translation>
    </message>
    <message>
        <source>About &amp;Qt</source>
        <translation>Über &amp;Qt</translation>
    </message>
    <message>
        <source>Save mesh</source>
        <translation>Gitter sichern</translation>
    </message>
    <message>
        <source>Meshes (%1)</source>
        <translation>Gitter (%1)</translation>
    </message>
    <message>
        <source>Save polygons</source>
        <translation>Polygone sichern</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Results of a study</source>
        <translation>Ergebnisse einer Studie</translation>
    </message>
    <message>
        <source>About PEMesh Studio</source>
        <translation>Über PEMesh Studio</translation>
    </message>
    <message>
        <source>&lt;h3&gt;PEMesh Studio %1&lt;/h3&gt;&lt;p&gt;How the geometry of polygonal meshes affects polytopal element methods.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later. It uses Qt, VTK, CGAL, Eigen, SuiteSparse, METIS, Boost, Cairo and nlohmann-json, each under a licence of its own.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;PEMesh Studio %1&lt;/h3&gt;&lt;p&gt;Wie die Geometrie von Polygongittern Polytopal-Element-Methoden beeinflusst.&lt;/p&gt;&lt;p&gt;Freie Software unter der GNU General Public License, Version 3 oder später. Sie benutzt Qt, VTK, CGAL, Eigen, SuiteSparse, METIS, Boost, Cairo und nlohmann-json, jedes unter eigener Lizenz.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>pemesh::StudioWindow</name>
    <message>
        <source>%1 meshes are marked</source>
        <translation>%1 Gitter sind markiert</translation>
    </message>
    <message>
        <source>%1 elements are marked</source>
        <translation>%1 Elemente sind markiert</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>Geometrie</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Löser</translation>
    </message>
    <message>
        <source>Correlation</source>
        <translation>Korrelation</translation>
    </message>
    <message>
        <source>%1 (Ctrl+%2)</source>
        <translation>%1 (Strg+%2)</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>New study</source>
        <translation>Neue Studie</translation>
    </message>
    <message>
        <source>Open study</source>
        <translation>Studie öffnen</translation>
    </message>
    <message>
        <source>Save study</source>
        <translation>Studie sichern</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Undo %1</source>
        <translation>Rückgängig: %1</translation>
    </message>
    <message>
        <source>Redo %1</source>
        <translation>Wiederholen: %1</translation>
    </message>
</context>
<context>
    <name>pemesh::StudyModel</name>
    <message>
        <source>List the %1</source>
        <translation>%1 auflisten</translation>
    </message>
    <message>
        <source>Untitled study</source>
        <translation>Studie ohne Namen</translation>
    </message>
</context>
<context>
    <name>pemesh::StyleDialog</name>
    <message>
        <source>Plot settings</source>
        <translation>Diagramme einrichten</translation>
    </message>
    <message>
        <source>all studies</source>
        <translation>alle Studien</translation>
    </message>
    <message>
        <source>this study, saved with it</source>
        <translation>diese Studie, mit ihr gesichert</translation>
    </message>
    <message>
        <source>Settings of</source>
        <translation>Gilt für</translation>
    </message>
    <message>
        <source>Load …</source>
        <translation>Laden …</translation>
    </message>
    <message>
        <source>Save as …</source>
        <translation>Sichern unter …</translation>
    </message>
    <message>
        <source>Take the settings of a style that was saved as a file</source>
        <translation>Die Einstellungen eines Stils übernehmen, der als Datei gesichert wurde</translation>
    </message>
    <message>
        <source>Save these settings as a style of a name, for other studies and commands</source>
        <translation>Diese Einstellungen als Stil mit einem Namen sichern, für andere Studien und Befehle</translation>
    </message>
    <message>
        <source>Load a style</source>
        <translation>Stil laden</translation>
    </message>
    <message>
        <source>Styles (*.json)</source>
        <translation>Stile (*.json)</translation>
    </message>
    <message>
        <source>Save the style</source>
        <translation>Stil sichern</translation>
    </message>
    <message>
        <source>Default style</source>
        <translation>Vorgegebener Stil</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
</context>
<context>
    <name>pemesh::SurfaceWindow</name>
    <message>
        <source>Solution and ground truth</source>
        <translation>Lösung und wahre Lösung</translation>
    </message>
    <message>
        <source>Solution</source>
        <translation>Lösung</translation>
    </message>
    <message>
        <source>Ground truth</source>
        <translation>Wahre Lösung</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>This mesh has no solution.</source>
        <translation>Dieses Gitter hat keine Lösung.</translation>
    </message>
    <message>
        <source>The solver gave no ground truth.</source>
        <translation>Der Löser gab keine wahre Lösung.</translation>
    </message>
    <message>
        <source>A large mesh: an outline while it moves.</source>
        <translation>Ein großes Gitter: ein Umriss, solange es sich bewegt.</translation>
    </message>
</context>
<context>
    <name>pemesh::TimeBar</name>
    <message>
        <source>Play (Space)</source>
        <translation>Abspielen (Leertaste)</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Deformation or mesh</source>
        <translation>Verformung oder Gitter</translation>
    </message>
</context>
</TS>
